#include "stress/stressed_cell.h"

#include "core/error.h"
#include "core/json_text.h"
#include "image/image_file.h"
#include "jobs/contest/truth_image.h"

#include <vector>

namespace aoscore {
namespace {

constexpr const char* kNumbers = "aoscore:stress_cell";

}  // namespace

StressedPicture stressed_picture(const StressWork& work, const StressRequest& request,
                                 const ViewMaker& maker) {
    const Mask& drawn = maker.gbuffer()->surface;
    if (!work.stress.has_truth) return {maker.image()->visibility, drawn, drawn};
    const Truth& truth = *maker.truth();
    const std::size_t q = query_index(truth, request.own);
    const Mask& surface = request.contestant->gbuffer_inputs() ? drawn : truth.hits.surface;
    return {maker.image()->visibility, surface, maker.ground()->contract.valid, &truth.visibility[q],
            &truth.standard_error[q]};
}

void write_stressed_cell(const std::filesystem::path& path, const StressedCell& cell) {
    std::vector<ChannelView> channels{{"Y", &cell.picture}};
    if (!cell.difference.empty()) channels.push_back({"D", &cell.difference});
    write_exr(path, channels, {{kNumbers, json_text(to_json(cell.cell))}});
}

StressedCell read_stressed_cell(const std::filesystem::path& path) {
    const ImageFile file = read_image(path);
    const ImageF *picture = file.channel("Y"), *difference = file.channel("D");
    const auto numbers = file.attributes.find(kNumbers);
    if (picture == nullptr || numbers == file.attributes.end())
        throw file_error("is no stressed cell", path.string());
    const nlohmann::json json = nlohmann::json::parse(numbers->second, nullptr, false);
    return {stress_cell_from_json(json, path.string()), *picture,
            difference != nullptr ? *difference : ImageF()};
}

}  // namespace aoscore
