#include "store/key.h"

#include "store/code_digest.h"

namespace aoscore {

KeyBuilder::KeyBuilder(std::string_view kind, std::string_view code) {
    digest_.text(kind).text(code_digest(code));
}

KeyBuilder& KeyBuilder::text(std::string_view value) {
    digest_.text(value);
    return *this;
}

KeyBuilder& KeyBuilder::camera(const Camera& camera) {
    digest_.value(camera.projection).value(camera.position).value(camera.target).value(camera.up);
    digest_.value(camera.fovy_rad).value(camera.half_height).value(camera.near).value(camera.far);
    return *this;
}

}  // namespace aoscore
