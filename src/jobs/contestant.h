#pragma once

#include "core/image.h"
#include "jobs/scene_tools.h"
#include "screen/screen.h"

#include <memory>
#include <string_view>

namespace aoscore {

/// What can be scored on a view: it gives an image of visibility, and has a cost or none. Behind it:
/// ShaderMethod, a folder of shaders/methods/ drawn by the renderer (its passes on the processor included),
/// and FewRays, the ray tracer with as few rays as a frame has time for.
class Contestant {
  public:
    virtual ~Contestant() = default;

    /// The code that makes its image, by its name in code_digest().
    virtual std::string_view code() const = 0;
    /// Its image, raw and filtered, on the G-buffer that the renderer holds of the chosen scene.
    virtual MethodOutput image(SceneTools& tools, const CameraFrame& frame) const = 0;
    /// Whether its passes are timed and their fetches counted.
    virtual bool has_cost() const = 0;
};

/// The contestant that a request asks for; the request must outlive it.
std::unique_ptr<const Contestant> contestant_of(const MethodRequest& request);

}  // namespace aoscore
