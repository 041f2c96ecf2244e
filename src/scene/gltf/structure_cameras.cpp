#include "scene/gltf/structure.h"

#include <fmt/format.h>

#include <numbers>

namespace aoscore::gltf {
namespace {

void check_perspective(CheckedObject& lens, std::vector<std::string>& warnings) {
    const auto yfov = lens.number("yfov");
    if (!yfov || !(*yfov > 0 && *yfov < std::numbers::pi)) {
        lens.fail("yfov", yfov ? fmt::format("is {} rad", *yfov) : "is missing", "more than 0, less than pi");
    }
    if (*yfov < 1e-3) {
        warnings.push_back(
            fmt::format("{} is {} rad: one sees next to nothing", Place(lens.place(), "yfov").text(), *yfov));
    }
    const auto near = lens.number("znear");
    if (!near || !(*near > 0)) {
        lens.fail("znear", near ? fmt::format("is {} m", *near) : "is missing", "more than 0");
    }
    const auto far = lens.number("zfar");
    if (far && !(*far > *near)) lens.fail("zfar", fmt::format("is {} m", *far), "more than znear");
    // The picture has the shape that the user asks for.
    const auto aspect = lens.number("aspectRatio");
    if (aspect && !(*aspect > 0)) {
        warnings.push_back(
            fmt::format("{} is {}: not used", Place(lens.place(), "aspectRatio").text(), *aspect));
    }
}

void check_orthographic(CheckedObject& lens) {
    for (const char* key : {"xmag", "ymag"}) {
        const auto magnification = lens.number(key);
        if (!magnification || *magnification == 0) lens.fail(key, "is missing or 0", "another number");
    }
    const auto near = lens.number("znear"), far = lens.number("zfar");
    if (!near || *near < 0) lens.fail("znear", "is missing or negative", "0 or more");
    if (!far || !(*far > *near)) lens.fail("zfar", "is missing or not beyond znear", "more than znear");
}

}  // namespace

void check_cameras(CheckedObject& root, std::vector<std::string>& warnings) {
    root.objects("cameras", [&](CheckedObject& camera, std::size_t) {
        const std::string type = camera.required_text("type");
        if (type == "perspective") {
            camera.required_object("perspective",
                                   [&](CheckedObject& lens) { check_perspective(lens, warnings); });
        } else if (type == "orthographic") {
            camera.required_object("orthographic", check_orthographic);
        } else {
            camera.fail("type", "is unknown", "perspective, orthographic");
        }
    });
}

}  // namespace aoscore::gltf
