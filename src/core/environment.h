#pragma once

#include "core/image.h"
#include "core/sky.h"

#include <glm/glm.hpp>

#include <string>
#include <utility>
#include <variant>

namespace aoscore {

/// The luminance of linear red, green and blue with the primaries of sRGB (ITU-R BT.709).
double luminance(const glm::dvec3& colour);

/// A picture of the light from all around, in equirectangular projection: twice as wide as high, linear, rows
/// from the zenith, +y, to the nadir. The middle of the picture lies towards +x and its right half towards
/// +z, so that nothing is mirrored for one who looks out from within.
struct EnvironmentMap {
    Image<glm::vec3> radiance;  ///< linear red, green and blue of each texel
    double turn_rad = 0;        ///< counterclockwise about +y, seen from above

    /// The unit direction from which a point of the picture shines; 0 to 1 from the left and from the top.
    glm::dvec3 direction(double across, double down) const;
    /// The texel in a unit direction.
    const glm::vec3& at(const glm::dvec3& from) const;
    /// The solid angle of a texel of this row.
    double solid_angle(int row) const;
    /// The same light in a picture of at most `width` texels a row: means by solid angle over whole texels,
    /// for a width that divides this one's; as it is where none does.
    EnvironmentMap reduced(int width) const;
};

/// Light from all around, infinitely far away: a function of the direction alone.
class Environment {
  public:
    /// The sky's terms; its id is "sky".
    Environment(const Sky& sky) : light_(sky), id_("sky") {}
    /// The picture, which must have been checked (image/environment_file.h).
    Environment(EnvironmentMap map, std::string id) : light_(std::move(map)), id_(std::move(id)) {}

    /// Linear red, green and blue from a unit direction.
    glm::dvec3 radiance(const glm::dvec3& from) const;
    /// The sky; null where the light is a picture's.
    const Sky* sky() const { return std::get_if<Sky>(&light_); }
    /// The picture; null where the light is a sky's.
    const EnvironmentMap* map() const { return std::get_if<EnvironmentMap>(&light_); }
    /// "sky", or how the command names the picture.
    const std::string& id() const { return id_; }
    /// The digest of all that decides the light.
    std::string digest() const;

  private:
    std::variant<Sky, EnvironmentMap> light_;
    std::string id_;
};

}  // namespace aoscore
