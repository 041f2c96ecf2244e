#include "jobs/contest/few_rays.h"

#include "core/sampling.h"

namespace aoscore {

MethodDescriptor few_rays_descriptor() {
    MethodDescriptor method;
    method.id = kFewRays;
    method.label = "Ray tracing, few rays";
    method.paper = "none: the truth's own rays, as few as a frame has time for";
    method.summary = "Cosine-distributed rays from every pixel into the scene itself, a few of them";
    Parameter rays{"rays", Parameter::Type::integer, 4, 1, 256, {}, "", "a pixel", 0};
    Parameter radius{"radius", Parameter::Type::real, 0.5, 1e-9, 1e7, {}, "m", "length of the rays", 1};
    method.parameters = {rays, radius};
    method.presets["default"];
    method.reference_radius = {"radius", 0};
    method.truth = {"binary", "radius", "", ""};
    return method;
}

bool is_few_rays(const MethodRequest& request) {
    return request.method->id == kFewRays && request.method->folder.empty();
}

ImageF trace_few_rays(const ReferenceScene& reference, const CameraFrame& frame,
                      const MethodRequest& request) {
    constexpr std::uint64_t kOfItsOwn = 0x66657720726179ull;
    TruthSettings settings;
    settings.samples = request.parameters.at("rays").number();
    settings.seed = mix_bits(request.seed ^ kOfItsOwn);
    const TruthQuery query{Falloff::binary, request.parameters.at("radius").number(), 0};
    return reference.trace(frame, {query}, settings, "few rays").visibility.front();
}

}  // namespace aoscore
