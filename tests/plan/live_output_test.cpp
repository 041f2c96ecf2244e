#include "plan/live_output.h"

#include "core/files.h"
#include "results/live_file.h"
#include "support/support.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace aoscore {
namespace {

TEST(LiveFile, HasTheWholeRegistryAndEveryCamera) {
    Camera camera;
    const CameraFrame wide(camera, 32, 16);
    camera.projection = Camera::Projection::orthographic;
    camera.half_height = 2;
    const CameraFrame flat(camera, 16, 8);
    const Registry registry = load_registry();
    const std::filesystem::path folder = testing::output_dir();
    write_live_file(folder, registry, "mine",
                    {{"scene/wide", {wide, 1.0}}, {"scene/flat", {flat, std::nullopt}}}, 3);

    const nlohmann::json data = nlohmann::json::parse(read_file(folder / kLiveFile));
    EXPECT_EQ(data["methods"].size(), registry.methods.size());
    EXPECT_EQ(data["filters"].size(), registry.filters.size());
    EXPECT_EQ(data["contract"]["seed"], 3);
    EXPECT_EQ(data["methods_dir"], "mine");
    EXPECT_FALSE(data["views"]["scene/wide"]["orthographic"].get<bool>());
    EXPECT_NEAR(data["views"]["scene/wide"]["pixel_size"][1].get<double>(), wide.pixel_footprint(1), 1e-12);
    EXPECT_TRUE(data["views"]["scene/flat"]["orthographic"].get<bool>());
    EXPECT_NEAR(data["views"]["scene/flat"]["pixel_size"][1].get<double>(), 0.5, 1e-12);
}

TEST(LiveFile, SaysOfEveryViewHowLongPresetsAreThere) {
    const CameraFrame frame(Camera(), 32, 16);
    const Registry registry = load_registry();
    const std::filesystem::path folder = testing::output_dir();
    write_live_file(folder, registry, "", {{"drawn", {frame, 1.0}}, {"own", {frame, std::nullopt}}}, 3);
    const nlohmann::json views = nlohmann::json::parse(read_file(folder / kLiveFile))["views"];
    EXPECT_FALSE(views["drawn"]["own_parameters"].get<bool>());
    EXPECT_TRUE(views["own"]["own_parameters"].get<bool>());
    EXPECT_EQ(views["drawn"]["method_lengths"]["alchemy"]["default"]["sigma"], 0.256);
    EXPECT_EQ(views["own"]["method_lengths"]["alchemy"]["default"]["sigma"], 0.128);
    EXPECT_EQ(views["drawn"]["method_lengths"]["alchemy"]["quality"]["sigma"], 0.139) << "an absolute preset";
    EXPECT_EQ(views["drawn"]["filter_lengths"]["normal-depth"]["default"]["distance_unit"], 0.2);
    EXPECT_FALSE(views["drawn"]["method_lengths"].contains("line-sweep")) << "it has no length";
}

TEST(LiveFile, AsksForWhatAnyMethodReadsOfTheGBuffer) {
    const std::set<std::string> inputs = gbuffer_inputs_of(load_registry());
    EXPECT_TRUE(inputs.contains("linear_depth"));
    EXPECT_TRUE(inputs.contains("normal_geometric"));
}

}  // namespace
}  // namespace aoscore
