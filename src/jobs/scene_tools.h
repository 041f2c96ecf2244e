#pragma once

#include "reference/truth.h"
#include "scene/scene.h"
#include "screen/screen.h"

#include <cstdint>
#include <optional>
#include <string>

namespace aoscore {

/// The tracer and the renderer of a scene, made ready only when they are needed: a run that finds everything
/// in the store builds nothing.
class SceneTools {
  public:
    SceneTools();
    SceneTools(const SceneTools&) = delete;  // the renderer asks this one for layers by rays
    SceneTools& operator=(const SceneTools&) = delete;

    /// Chooses the scene to measure from here on, which must outlive its use.
    void choose(const Scene& scene);

    /// The tracer of the chosen scene, which is built for rays only when some are wanted, and as far as their
    /// radius.
    const ReferenceScene& reference();
    /// The renderer with the chosen scene uploaded. Where the driver has lost the context, it is a new one, with
    /// the last G-buffer drawn again: what was being drawn has failed, and what follows need not.
    ScreenRenderer& ready_renderer();
    /// The renderer, for questions about OpenGL itself.
    ScreenRenderer& renderer() { return renderer_; }

  private:
    ScreenRenderer renderer_;
    const Scene* scene_ = nullptr;
    std::string digest_;  ///< the chosen scene's
    const Scene* uploaded_ = nullptr;
    std::optional<ReferenceScene> reference_;
};

}  // namespace aoscore
