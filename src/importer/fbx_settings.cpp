#include "importer/fbx_settings.h"

#include <assimp/metadata.h>

#include <cmath>
#include <cstdint>

namespace aoscore::importer {
namespace {

std::int32_t setting(const aiMetadata& settings, const char* key, std::int32_t fallback) {
    std::int32_t value = fallback;
    return settings.Get(key, value) ? value : fallback;
}

/// The direction that an axis and its sign name; zero where they name none.
glm::dvec3 direction(const aiMetadata& settings, const char* axis, const char* sign, std::int32_t fallback) {
    const std::int32_t number = setting(settings, axis, fallback);
    glm::dvec3 v(0);
    if (number >= 0 && number < 3) v[number] = setting(settings, sign, 1) < 0 ? -1 : 1;
    return v;
}

double unit_in_cm(const aiMetadata& settings) {
    double unit = 0;
    float single = 0;
    if (settings.Get("UnitScaleFactor", unit)) return unit;
    return settings.Get("UnitScaleFactor", single) ? static_cast<double>(single) : 1;
}

}  // namespace

void read_fbx_settings(ImportJob& job, const aiScene& scene) {
    if (scene.mMetaData == nullptr) return;
    const aiMetadata& settings = *scene.mMetaData;
    const double unit = unit_in_cm(settings);
    if (unit > 0 && std::isfinite(unit)) job.plain.metres_per_unit = unit / 100;
    const glm::dvec3 right = direction(settings, "CoordAxis", "CoordAxisSign", 0);
    const glm::dvec3 up = direction(settings, "UpAxis", "UpAxisSign", 1);
    const glm::dvec3 front = direction(settings, "FrontAxis", "FrontAxisSign", 2);
    const glm::dmat3 file_from_y_up(right, up, front);
    if (std::abs(glm::determinant(file_from_y_up)) != 1) {
        job.warn("its axes are not three different ones: taken as y up");
        return;
    }
    job.plain.states_axes = true;
    job.plain.y_up_from_file = glm::transpose(file_from_y_up);
}

}  // namespace aoscore::importer
