#include "core/error.h"
#include "core/files.h"
#include "image/image_file.h"
#include "page/live/live_data.h"
#include "page/live/live_packing.h"
#include "page/live/live_preview.h"
#include "page/pictures/pictures.h"
#include "page/synthetic_results.h"
#include "results/live_file.h"
#include "support/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

/// Tests the page's data for its live section; tests/browser shows that they unpack to the same numbers.
namespace aoscore {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;

/// A method as in screen/method_data.h, without its shaders' text.
json processed(const std::string& id, const std::string& label) {
    return {{"id", id},
            {"label", label},
            {"summary", "…"},
            {"parameters", json::array({{{"id", "radius"},
                                         {"type", "real"},
                                         {"default", 0.5},
                                         {"low", 0.01},
                                         {"high", 10},
                                         {"unit", "m"},
                                         {"length_power", 1},
                                         {"meaning", "…"}}})},
            {"presets", {{"default", {{"radius", 0.5}}}}},
            {"preset_filters", json::object()},
            {"absolute_presets", json::object()},
            {"processor", "line_sweep"}};
}

json method(const std::string& id, const std::vector<std::string>& inputs) {
    json data = processed(id, id);
    data.erase("processor");
    data["sources"] = {"void main() {}"};
    data["passes"] = {{{"inputs", inputs}, {"scale", 1}, {"source", 0}}};
    data["kernels"] =
        json::array({{{"id", "disc"},
                      {"size", "2"},
                      {"scale", "none"},
                      {"largest", 2},
                      {"tables", {{{"when", json::object()}, {"points", {0, 0, 1, 0, 1, 0}}}}}}});
    data["depth_mips"] = {{"filter", "rotated_grid"}, {"radius", ""}};
    return data;
}

json camera(const ViewRecord& view) {
    return {{"width", view.width},
            {"height", view.height},
            {"near_m", 0.1},
            {"far_m", 100},
            {"pixel_size", {0.01, 0.01}},
            {"orthographic", false},
            {"surfaces", false},
            {"own_parameters", false},
            {"method_lengths", {{"depth-only", {{"default", {{"radius", 0.5}}}}}}},
            {"filter_lengths", json::object()}};
}

struct LiveFolder {
    fs::path folder = testing::output_dir();
    Results results = testing::synthetic_results();
    json live = {{"contract",
                  {{"screen_vertex", "void main() {}"},
                   {"derived", {{"upsample.frag", "void main() {}"}}},
                   {"noise_4x4", std::vector<double>(64, 0.5)},
                   {"macros", {{"SCALE", 1}}},
                   {"depth_mip_levels", 6},
                   {"layer_samplings", {{"stratified", "SAMPLING_STRATIFIED"}}},
                   {"seed", 1}}},
                 {"methods_dir", ""},
                 {"methods", {method("depth-only", {"linear_depth", "noise_4x4", "depth_mips"})}},
                 {"filters", json::array()},
                 {"views", json::object()}};

    LiveFolder() {
        testing::write_synthetic(results, folder);
        for (const ViewRecord& view : results.views) live["views"][view.key] = camera(view);
    }
    LiveData read() const {
        write_atomically(folder / kLiveFile, live.dump());
        LiveData data = read_live_data(results, folder);
        make_pictures(results, folder, false,
                      [&](const ViewRecord& view, const ImageFile& gbuffer, const fs::path& path) {
                          return add_gbuffer(data, view, gbuffer, path);
                      });
        return data;
    }
};

TEST(LiveData, HoldsWhatMethodsReadOfEachViewAndNoMore) {
    const LiveFolder folder;
    const LiveData data = folder.read();
    EXPECT_EQ(data.missing, "");
    ASSERT_EQ(data.blocks.size(), 4U) << "depth and its preview, of two views";
    EXPECT_EQ(data.blocks[0].first, "live atrium/wide linear_depth");
    const json& view = data.index["views"]["atrium/wide"];
    EXPECT_EQ(view["inputs"].size(), 1U);
    EXPECT_EQ(view["inputs"]["linear_depth"]["data"], data.blocks[0].first);
    EXPECT_EQ(view["preview_inputs"].size(), 1U);
    EXPECT_EQ(view["preview_inputs"]["linear_depth"]["data"], data.blocks[1].first);
    EXPECT_EQ(view["noise_floor_rmse"], 0.031);
    std::size_t cells = 0;
    for (const CellRecord& cell : folder.results.cells)
        cells += cell.view_key == "atrium/wide" && cell.error.empty();
    EXPECT_EQ(view["cells"].size(), cells);
}

TEST(LiveData, RefusesWhatNoBrowserCanRunAndSaysWhy) {
    LiveFolder folder;
    folder.live["methods"].push_back(processed("swept", "Swept"));
    folder.live["methods"].push_back(method("coloured", {"albedo"}));
    const LiveData data = folder.read();
    EXPECT_EQ(data.index["methods"].size(), 1U);
    ASSERT_EQ(data.refused.size(), 2U);
    EXPECT_EQ(data.refused[0].label, "Swept");
    EXPECT_THAT(data.refused[0].reason, HasSubstr("line_sweep"));
    EXPECT_THAT(data.refused[1].reason, HasSubstr("albedo"));
}

void expect_file_error(const LiveFolder& folder) {
    try {
        folder.read();
        FAIL() << "no error";
    } catch (const Error& e) {
        EXPECT_EQ(e.exit_code(), ExitCode::file_error) << e.what();
    }
}

/// A method over depth layers with a preset for each of these samplings.
json layered(const std::vector<std::string>& samplings) {
    json data = method("layered", {"linear_depth", "depth_layers", "side_layers"});
    data["parameters"].push_back({{"id", "sampling"},
                                  {"type", "choice"},
                                  {"default", "stratified"},
                                  {"choices", {"stratified", "rays"}},
                                  {"unit", ""},
                                  {"length_power", 0},
                                  {"meaning", "…"}});
    data["parameters"].push_back({{"id", "cameras"},
                                  {"type", "integer"},
                                  {"default", 0},
                                  {"low", 0},
                                  {"high", 4},
                                  {"unit", ""},
                                  {"length_power", 0},
                                  {"meaning", "…"}});
    data["presets"] = json::object();
    for (const std::string& sampling : samplings)
        data["presets"][sampling] = {{"radius", 0.5}, {"sampling", sampling}, {"cameras", 0}};
    data["depth_layers"] = {{"samples", 4}, {"sampling", "@sampling"}};
    data["side_layers"] = {{"cameras", "@cameras"}, {"sampling", "@sampling"}};
    return data;
}

TEST(LiveData, RunsMethodsOverLayersWhereSurfacesWereKeptAndNamesWhatNeedsTheScene) {
    LiveFolder folder;
    folder.live["methods"].push_back(layered({"stratified", "rays"}));
    LiveData data = folder.read();
    EXPECT_EQ(data.index["methods"].size(), 1U);
    ASSERT_EQ(data.refused.size(), 1U);
    EXPECT_THAT(data.refused[0].reason, HasSubstr("depth_layers"));

    for (auto& view : folder.live["views"]) view["surfaces"] = true;
    folder.live["methods"][1]["presets"]["cameras"] = {
        {"radius", 0.5}, {"sampling", "stratified"}, {"cameras", 1}};
    write_atomically(folder.folder / kLiveFile, folder.live.dump());
    data = read_live_data(folder.results, folder.folder);
    ASSERT_EQ(data.index["methods"].size(), 2U);
    const json& method = data.index["methods"][1];
    EXPECT_EQ(method["presets"].size(), 1U);
    EXPECT_EQ(method["parameters"][1]["not_here"], json({"rays"}));
    EXPECT_EQ(method["parameters"][2]["high"], 0);
    ASSERT_EQ(data.refused.size(), 2U);
    EXPECT_THAT(data.refused[0].label + data.refused[0].reason, HasSubstr("further cameras"));
    EXPECT_THAT(data.refused[1].label + data.refused[1].reason, HasSubstr("rays"));
    expect_file_error(folder);  // the G-buffers' files have no surfaces
}

TEST(LiveData, SaysWhatIsMissing) {
    LiveFolder folder;
    EXPECT_THAT(read_live_data(folder.results, folder.folder).missing, HasSubstr(kLiveFile));
    folder.results.views[1].gbuffer_file.clear();
    EXPECT_THAT(folder.read().missing, HasSubstr("G-buffer"));
}

TEST(LiveData, RejectsADamagedFileAChannelThatLacksAndAPlaceOutside) {
    LiveFolder folder;
    folder.live["views"].erase("atrium/wide");
    expect_file_error(folder);
    LiveFolder normals;
    normals.live["methods"].push_back(method("normals", {"normal_geometric"}));
    expect_file_error(normals);
    LiveFolder outside;
    outside.results.views[0].gbuffer_file = "../elsewhere.exr";
    expect_file_error(outside);
}

/// Every place in the document: "/methods/0/passes/0/scale".
std::vector<json::json_pointer> places_in(const json& document) {
    std::vector<json::json_pointer> places;
    const json flat = document.flatten();
    for (const auto& [path, value] : flat.items()) {
        for (json::json_pointer place(path); !place.empty(); place = place.parent_pointer()) {
            if (std::ranges::find(places, place) == places.end()) places.push_back(place);
        }
    }
    return places;
}

/// Whether the object at this place may have members of any name.
bool names_freely(const json::json_pointer& place) {
    static const std::set<std::string> kObjects{"views",      "derived", "macros",
                                                "presets",    "default", "method_lengths",
                                                "depth-only", "when",    "layer_samplings"};
    return !place.empty() && kObjects.contains(place.back());
}

TEST(LiveData, IsReadStrictlyWhereverItIsDamaged) {
    LiveFolder folder;
    const json good = folder.live;
    for (const json::json_pointer& place : places_in(good)) {
        folder.live = good;
        folder.live[place] = nullptr;
        EXPECT_THROW(folder.read(), Error) << place << " is null";
        if (good[place].is_object() && !names_freely(place)) {
            folder.live = good;
            folder.live[place]["unknown"] = 1;
            EXPECT_THROW(folder.read(), Error) << place << " has an unknown member";
        }
        if (!good[place.parent_pointer()].is_object() || names_freely(place.parent_pointer())) continue;
        folder.live = good;
        folder.live[place.parent_pointer()].erase(place.back());
        EXPECT_THROW(folder.read(), Error) << place << " is missing";
    }
}

TEST(LiveData, NamesThePlaceAndWhatWouldBeValid) {
    LiveFolder folder;
    folder.live["methods"][0]["passes"][0]["scale"] = 1.5;
    try {
        folder.read();
        ADD_FAILURE();
    } catch (const Error& e) {
        EXPECT_EQ(e.exit_code(), ExitCode::file_error);
        EXPECT_THAT(e.what(), HasSubstr("live.json: methods[0].passes[0].scale: is 1.5"));
        EXPECT_THAT(e.what(), HasSubstr("a whole number from 1 to 64"));
    }
}

TEST(LiveData, HoldsDepthOnceForTheStageAndForTheMethods) {
    const LiveFolder folder;
    write_atomically(folder.folder / kLiveFile, folder.live.dump());
    LiveData data = read_live_data(folder.results, folder.folder);
    const auto make = [&](const GBufferUse& use) {
        return make_pictures(folder.results, folder.folder, false, use);
    };
    const Pictures shared = make([&](const ViewRecord& view, const ImageFile& gbuffer, const fs::path& path) {
        return add_gbuffer(data, view, gbuffer, path);
    });
    const Pictures alone = make({});
    for (const auto& [key, view] : shared.views) {
        const QuantisedImage& own = alone.views.at(key).depth;
        EXPECT_EQ(view.depth_block, "live " + key + " linear_depth");
        EXPECT_TRUE(view.depth.empty());
        EXPECT_FALSE(own.empty());
        EXPECT_EQ(std::pair(view.depth.low, view.depth.step), std::pair(own.low, own.step));
    }
}

TEST(LivePreview, TakesTheMiddleOfEachSquareAndAtMostANinth) {
    EXPECT_EQ(preview_factor(1), 3);
    EXPECT_EQ(preview_factor(640), 3);
    EXPECT_EQ(preview_factor(1920), 6);
    Image<int> image(7, 4);
    std::iota(image.pixels.begin(), image.pixels.end(), 0);
    const Image<int> preview = preview_of(image, 3);
    EXPECT_EQ(std::pair(preview.width, preview.height), std::pair(3, 2));
    EXPECT_EQ(preview.pixels, (std::vector{8, 11, 13, 22, 25, 27})) << "x of 1, 4, 6 and y of 1, 3";
    EXPECT_EQ(preview_of(Image<int>(1, 1, 5), 3).pixels, std::vector{5});
}

TEST(LivePacking, SpendsLittleOnPlanesAndRepeatsOnItself) {
    ImageF plane(256, 128);
    for (int y = 0; y < plane.height; ++y) {
        for (int x = 0; x < plane.width; ++x)
            plane.at(x, y) = 1.0F / (0.5F - 0.001F * static_cast<float>(x) - 0.0005F * static_cast<float>(y));
    }
    const std::string packed = pack_floats(plane).data;
    EXPECT_EQ(packed, pack_floats(plane).data);
    EXPECT_LT(packed.size(), plane.size() * sizeof(float) / 2);
    EXPECT_LT(pack_normals(Image<glm::vec3>(256, 128, glm::vec3(0, 0, 1))).data.size(), 1000U);
}

TEST(LivePacking, PredictsTheNormalsOfCurvedSurfacesAlone) {
    Image<glm::vec3> facets(256, 128), sphere(256, 128);
    for (int y = 0; y < facets.height; ++y) {
        for (int x = 0; x < facets.width; ++x) {
            const int facet = (3 * x + y) / 50 + 7 * ((3 * y - x + 256) / 40);
            facets.at(x, y) = glm::normalize(glm::vec3(facet * 37 % 19 - 9, facet * 53 % 23 - 11, 12));
            sphere.at(x, y) = glm::normalize(glm::vec3(x - 128, y - 64, 200));
        }
    }
    EXPECT_EQ(pack_normals(facets).kind, "normals");
    const PackedInput curved = pack_normals(sphere);
    EXPECT_EQ(curved.kind, "predicted normals");
    EXPECT_LT(curved.data.size(), sphere.size() * 4 * 16 / 13 / 2) << "half of the codes' own text";
}

}  // namespace
}  // namespace aoscore
