#include "page/index/index_contents.h"

#include "metrics/roles.h"
#include "page/document/stage_link.h"
#include "page/pictures/stored_images.h"
#include "page/pictures/thumbnail.h"
#include "page/section.h"
#include "results/light_errors.h"
#include "results/ranked_value.h"

#include <fmt/format.h>

#include <utility>

namespace aoscore {
namespace {

namespace fs = std::filesystem;

constexpr int kPictureWidth_px = 128;

/// By view key.
using PicturesByView = std::map<std::string, std::string>;

PicturesByView pictures_of(const Results& results, const fs::path& folder) {
    PicturesByView pictures;
    for (const ViewRecord& view : results.views) {
        if (view.truth_file.empty() || view.truths.empty()) continue;
        const fs::path path = stored_path(folder, view.truth_file);
        const ImageFile truth = read_image(path);
        pictures[view.key] =
            gray_thumbnail(channel_of(truth, path, view.truths.front().channel), kPictureWidth_px).uri;
    }
    return pictures;
}

/// The ranks of cells on their views, by id.
std::map<std::string, std::string> ranks_of(const Results& results) {
    std::map<std::string, std::string> ranks;
    for (const RankingRecord& ranking : results.rankings) {
        if (ranking.view_keys.size() != 1) continue;
        for (const PlaceRecord& place : ranking.places) ranks[place.cell_ids.front()] = rank_text(place);
    }
    return ranks;
}

IndexedCell indexed(const CellRecord& cell, const std::string& page) {
    IndexedCell indexed;
    indexed.error = ranked_value(cell, kRankingMetric);
    if (cell.analysis && indexed.error) {
        const auto interval = cell.analysis->intervals.find(kRankingMetric);
        if (interval != cell.analysis->intervals.end()) indexed.interval = interval->second;
    }
    indexed.bias = ranked_value(cell, kBiasMetric);
    indexed.ms = cost_ms(cell);
    indexed.fetches = cell.fetches_per_pixel;
    indexed.failure = cell.error;
    if (page.empty()) return indexed;
    const bool shown = !cell.image_file.empty();
    indexed.link =
        page + (shown ? stage_link({{"view", cell.view_key}, {"cell", cell.id}, {"mode", "beside"}}) : "");
    return indexed;
}

}  // namespace

std::size_t IndexBuilder::place_of(const ViewRecord& view, const std::string& picture) {
    const std::string key =
        fmt::format("{}/{} {}x{} {:.9g}", view.scene, view.view, view.width, view.height, view.radius_m);
    const auto [found, added] = views_.emplace(key, contents_.views.size());
    if (added)
        contents_.views.push_back({view.scene, view.view, view.width, view.height, view.radius_m, picture});
    else if (IndexedView& known = contents_.views[found->second]; known.picture.empty())
        known.picture = picture;
    return found->second;
}

std::size_t IndexBuilder::place_of(const CellRecord& cell) {
    const std::string key =
        fmt::format("{}\n{}\n{}\n{}", cell.method, cell.preset, cell.setting, cell.filter);
    const auto [found, added] = contestants_.emplace(key, contents_.contestants.size());
    if (added) {
        const std::string filter = cell.filter == "none" ? "unfiltered" : cell.filter;
        contents_.contestants.push_back(
            {fmt::format("{}, {}, {}", shown_name(cell), cell.preset, filter), cell.role});
    }
    return found->second;
}

void IndexBuilder::add_cell(IndexedCell cell) {
    const auto [found, added] = cells_.emplace(std::pair(cell.view, cell.contestant), contents_.cells.size());
    if (added) {
        contents_.cells.push_back(std::move(cell));
        return;
    }
    IndexedCell& earlier = contents_.cells[found->second];
    if (earlier.made < cell.made) std::swap(earlier, cell);
    ++contents_.replaced[cell.results];
    if (!earlier.light) earlier.light = std::move(cell.light);
}

void IndexBuilder::add(const Results& results, const fs::path& folder) {
    for (const CellRecord& cell : results.cells) find_view(results, cell.view_key);
    const PicturesByView pictures = pictures_of(results, folder);
    const std::map<std::string, std::string> ranks = ranks_of(results);
    const fs::path page_file = folder / "index.html";
    const std::string page =
        fs::exists(page_file) ? percent_encoded(fs::relative(page_file, page_folder_).string()) : "";
    const std::string folder_name = fs::relative(fs::absolute(folder), page_folder_).string();
    for (const CellRecord& cell : results.cells) {
        const ViewRecord& view = find_view(results, cell.view_key);
        const auto picture = pictures.find(view.key);
        IndexedCell one = indexed(cell, page);
        one.view = place_of(view, picture == pictures.end() ? "" : picture->second);
        one.contestant = place_of(cell);
        if (const auto least = least_light_error(cell.light); least && view.light)
            one.light = {least->error->value, std::string(least->mode->label), view.light->environment};
        if (const auto rank = ranks.find(cell.id); rank != ranks.end()) one.rank = rank->second;
        one.made = results.created_utc;
        one.results = folder_name;
        add_cell(std::move(one));
    }
    ++contents_.read;
}

void IndexBuilder::add_unreadable(const fs::path& path, const std::string& reason) {
    contents_.unreadable.push_back({path.string(), reason});
}

}  // namespace aoscore
