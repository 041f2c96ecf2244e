#include "results/view_piece.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace aoscore {
namespace {

using nlohmann::ordered_json;

bool is_perspective(const ViewRecord& view) {
    return view.projection == "perspective";
}

glm::dvec3 vector_of(const std::vector<double>& numbers) {
    return {numbers.at(0), numbers.at(1), numbers.at(2)};
}

std::vector<double> numbers_of(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

}  // namespace

ordered_json view_piece(const ViewRecord& view) {
    ordered_json piece;
    piece["id"] = view.view;
    piece["position"] = view.position_m;
    piece["target"] = view.target_m;
    if (view.up != std::vector<double>{0, 1, 0}) piece["up"] = view.up;
    if (is_perspective(view))
        piece["fovy_deg"] = view.fovy_deg;
    else
        piece["half_height_m"] = view.half_height_m;
    piece["near_m"] = view.near_m;
    piece["far_m"] = view.far_m;
    if (view.radius_m > 0) piece["radius_m"] = view.radius_m;
    return piece;
}

ordered_json crop_piece(const ViewRecord& view, const PictureBox& box, const std::string& id) {
    const glm::dvec3 position = vector_of(view.position_m), target = vector_of(view.target_m);
    const double distance = glm::distance(position, target);
    const glm::dvec3 forward = (target - position) / distance;
    const glm::dvec3 right = glm::normalize(glm::cross(forward, vector_of(view.up)));
    const glm::dvec3 up = glm::cross(right, forward);
    // Half the picture's height, on a plane at distance 1, or in metres for an orthographic view.
    const double half = is_perspective(view) ? std::tan(glm::radians(view.fovy_deg) / 2) : view.half_height_m;
    const double per_pixel = 2 * half / view.height;
    const double x = (box.left + box.width / 2.0 - view.width / 2.0) * per_pixel;
    const double y = (view.height / 2.0 - box.top - box.height / 2.0) * per_pixel;
    const double shape = static_cast<double>(view.width) / view.height;
    const double crop_half = per_pixel * std::max<double>(box.height, box.width / shape) / 2;

    ViewRecord crop = view;
    crop.view = id;
    if (is_perspective(view)) {
        const glm::dvec3 sight = forward + right * x + up * y;
        crop.target_m = numbers_of(position + glm::normalize(sight) * distance);
        crop.fovy_deg = 2 * glm::degrees(std::atan(crop_half / glm::length(sight)));
    } else {
        crop.position_m = numbers_of(position + right * x + up * y);
        crop.target_m = numbers_of(target + right * x + up * y);
        crop.half_height_m = crop_half;
    }
    return view_piece(crop);
}

}  // namespace aoscore
