#pragma once

#include "reference/truth.h"
#include "scene/scene.h"
#include "screen/screen.h"

#include <cstdint>
#include <optional>
#include <string>

namespace aoscore {

/// What measures a scene, made ready only when something is asked of it: a run that finds everything in the
/// store builds nothing.
class SceneTools {
  public:
    /// The scene that is measured from here on; it must outlive its use.
    void choose(const Scene& scene);

    /// Of the chosen scene; built when rays are wanted, as far as they reach.
    const ReferenceScene& reference();
    /// With the chosen scene uploaded.
    ScreenRenderer& ready_renderer();
    /// For questions about OpenGL itself.
    ScreenRenderer& renderer() { return renderer_; }

  private:
    ScreenRenderer renderer_;
    const Scene* scene_ = nullptr;
    std::string digest_;  ///< of the chosen scene
    const Scene* uploaded_ = nullptr;
    std::optional<ReferenceScene> reference_;
};

}  // namespace aoscore
