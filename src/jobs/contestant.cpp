#include "jobs/contestant.h"

#include "jobs/draw_image.h"
#include "jobs/few_rays.h"

#include <utility>

namespace aoscore {
namespace {

class ShaderMethod final : public Contestant {
  public:
    explicit ShaderMethod(const MethodRequest& request) : request_(request) {}

    std::string_view code() const override { return "image"; }
    MethodOutput image(SceneTools& tools, const CameraFrame&) const override {
        return draw_image(tools.ready_renderer(), request_);
    }
    bool has_cost() const override { return true; }

  private:
    const MethodRequest& request_;
};

class FewRays final : public Contestant {
  public:
    explicit FewRays(const MethodRequest& request) : request_(request) {}

    std::string_view code() const override { return "few_rays"; }
    MethodOutput image(SceneTools& tools, const CameraFrame& frame) const override {
        MethodOutput output;
        output.raw = trace_few_rays(tools.reference(), frame, request_);
        output.visibility = tools.ready_renderer().filter(output.raw, request_);
        return output;
    }
    /// Rays on a processor say nothing of a graphics card's.
    bool has_cost() const override { return false; }

  private:
    const MethodRequest& request_;
};

}  // namespace

std::unique_ptr<const Contestant> contestant_of(const MethodRequest& request) {
    if (is_few_rays(request)) return std::make_unique<FewRays>(request);
    return std::make_unique<ShaderMethod>(request);
}

}  // namespace aoscore
