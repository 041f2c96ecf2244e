#include "core/error.h"
#include "hand_made.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <cmath>

namespace aoscore::testing {
namespace {

class EveryFilter : public ::testing::TestWithParam<std::string> {
  protected:
    const MethodDescriptor& filter() const { return find_method(filters_, GetParam()); }
    MethodOutput filtered(const std::string& method, const ParameterValues& filter_overrides = {}) {
        MethodRequest request = request_for(find_method(methods_, method), filters_, "default");
        request.filter = &filter();
        ParameterValues settings = filter_overrides;
        // A final power adds contrast, and roughness, of its own.
        if (filter().find_parameter("exponent") != nullptr) settings.try_emplace("exponent", 1.0);
        request.filter_parameters = filter().values("default", settings);
        return renderer_.run(request);
    }
    // Every value of every choice, one at a time.
    std::vector<ParameterValues> variants() const {
        std::vector<ParameterValues> all = {{}};
        for (const Parameter& p : filter().parameters) {
            for (const std::string& choice : p.choices) all.push_back({{p.id, choice}});
            if (p.type == Parameter::Type::boolean) {
                all.push_back({{p.id, true}});
                all.push_back({{p.id, false}});
            }
        }
        return all;
    }

    std::vector<MethodDescriptor> methods_ = load_methods();
    std::vector<MethodDescriptor> filters_ = load_filters();
    ScreenRenderer renderer_;
};

std::vector<std::string> filter_ids() {
    std::vector<std::string> ids;
    for (const MethodDescriptor& f : load_filters()) ids.push_back(f.id);
    return ids;
}

TEST_P(EveryFilter, LeavesAnOpenPlaneOpen) {
    renderer_.set_scene(plane_scene({0, 0, -4}, glm::normalize(glm::dvec3(2, 1, 1)), 30));
    renderer_.draw_gbuffer(CameraFrame(front_camera(), 96, 54), gbuffer_inputs());
    for (const ParameterValues& variant : variants()) {
        for (const float v : filtered("hbao", variant).visibility.pixels) ASSERT_NEAR(v, 1, 1e-6);
    }
}

TEST_P(EveryFilter, TakesNoiseOffAndStaysInRange) {
    renderer_.set_scene(corner_scene());
    renderer_.draw_gbuffer(CameraFrame(corner_camera(), 240, 135), gbuffer_inputs());
    const auto roughness = [](const ImageF& image) {
        double sum = 0;
        for (int y = 0; y < image.height; ++y) {
            for (int x = 1; x < image.width; ++x)
                sum += static_cast<double>(std::abs(image.at(x, y) - image.at(x - 1, y)));
        }
        return sum;
    };
    for (const ParameterValues& variant : variants()) {
        const MethodOutput output = filtered("ssao", variant);
        write_png((output_dir() / "filtered.png").string(), output.visibility);
        for (const float v : output.visibility.pixels) ASSERT_TRUE(v >= 0 && v <= 1);
        EXPECT_LT(roughness(output.visibility), 0.8 * roughness(output.raw));
    }
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryFilter, ::testing::ValuesIn(filter_ids()), [](const auto& tested) {
    std::string name = tested.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST(BoxFilter, IsTheMeanOfItsSquareWhateverTheSide) {
    const auto methods = load_methods();
    const auto filters = load_filters();
    ScreenRenderer renderer;
    renderer.set_scene(corner_scene());
    renderer.draw_gbuffer(CameraFrame(corner_camera(), 96, 54), gbuffer_inputs());
    MethodRequest request = request_for(find_method(methods, "ssao"), filters, "default");
    request.filter = &find_method(filters, "box-4x4");
    for (const int side : {1, 2, 3, 4, 7, 8}) {
        request.filter_parameters = request.filter->values("default", {{"size", side}});
        const MethodOutput output = renderer.run(request);
        // The centres lie beside the box's edge, so that the squares lie on surfaces.
        for (const glm::ivec2 centre : {glm::ivec2(30, 20), glm::ivec2(41, 30)}) {
            double mean = 0;
            for (int y = -(side / 2); y < side - side / 2; ++y) {
                for (int x = -(side / 2); x < side - side / 2; ++x)
                    mean += static_cast<double>(output.raw.at(centre.x + x, centre.y + y)) / (side * side);
            }
            EXPECT_NEAR(static_cast<double>(output.visibility.at(centre.x, centre.y)), mean, 1e-5) << side;
        }
    }
}

// Of two planes, one behind the other, a depth-aware filter must not carry occlusion over the edge.
TEST(GaussianDepth, KeepsOcclusionOnItsSideOfAnEdge) {
    const auto methods = load_methods();
    const auto filters = load_filters();
    Scene scene = plane_scene({0, 0, -6}, {0, 0, 1}, 30);
    add_quad(scene, {-30, -30, -3}, {30, 0, 0}, {0, 60, 0});    // a nearer plane on the left
    add_quad(scene, {-0.4, -30, -3}, {0, 0, 0.4}, {0, 60, 0});  // a thin wall on it
    ScreenRenderer renderer;
    renderer.set_scene(scene);
    const CameraFrame frame(front_camera(), 192, 108);
    renderer.draw_gbuffer(frame, gbuffer_inputs());
    MethodRequest request = request_for(find_method(methods, "hbao"), filters, "quality", {{"radius", 0.5}});
    for (const auto& [id, leaks] : {std::pair("gaussian-depth", false), std::pair("normal-depth", false)}) {
        request.filter = &find_method(filters, id);
        request.filter_parameters = request.filter->values("default");
        const ImageF visibility = renderer.run(request).visibility;
        for (int y = 40; y < 70; ++y) {
            for (int x = 97; x < 110; ++x)
                EXPECT_GT(visibility.at(x, y), leaks ? 0.0F : 0.995F) << id << " at " << x;
        }
    }
}

class EveryResolution : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryResolution, GivesNearlyTheFullPicture) {
    const auto methods = load_methods();
    ScreenRenderer renderer;
    renderer.set_scene(corner_scene());
    renderer.draw_gbuffer(CameraFrame(corner_camera(), 321, 181), gbuffer_inputs());
    const Mask surface = renderer.read_gbuffer().surface;
    MethodRequest request;
    request.method = &find_method(methods, GetParam());
    request.parameters = request.method->values("default");
    const ImageF full = renderer.run(request).raw;
    const double full_fetches = mean_over(renderer.count_fetches(request), surface);
    double before = 1;
    // A power multiplies slight occlusion by its exponent. Filament's root and Unity's power of 0.6 enlarge
    // it without bound: 0.15 and 0.18 of the mean and 0.36 and 0.32 a pixel, whose seven and eight taps are
    // noise, were measured here.
    const bool takes_root = GetParam() == "filament-ssao" || GetParam() == "unity-ssao";
    const auto final_power = request.parameters.find("final_power");
    const double power = final_power == request.parameters.end() ? 1 : final_power->second.number();
    const std::vector<Pass>& passes = request.method->passes;
    for (const auto resolution : {Resolution::half, Resolution::dual, Resolution::half_gbuffer}) {
        request.resolution = resolution;
        if (!passes[0].processor.empty() || (passes.size() > 1 && resolution == Resolution::dual)) {
            EXPECT_THROW(renderer.run(request), Error);
            continue;
        }
        const ImageF image = renderer.run(request).raw;
        write_png((output_dir() / (std::to_string(static_cast<int>(resolution)) + ".png")).string(), image);
        const double fetches = mean_over(renderer.count_fetches(request), surface);
        if (resolution == Resolution::half) {
            EXPECT_NEAR(fetches, full_fetches / 4, full_fetches / 40);
        }
        if (resolution == Resolution::dual) {
            EXPECT_GT(fetches, full_fetches / 4);
            EXPECT_LT(fetches, full_fetches * 1.26);
        }
        if (resolution == Resolution::half_gbuffer) {
            EXPECT_EQ(fetches, full_fetches);
        }
        double squared = 0, count = 0;
        for (std::size_t i = 0; i < image.size(); ++i) {
            ASSERT_TRUE(image.pixels[i] >= 0 && image.pixels[i] <= 1);
            if (surface.pixels[i] == 0) continue;
            squared += std::pow(static_cast<double>(image.pixels[i] - full.pixels[i]), 2);
            ++count;
        }
        const double error = std::sqrt(squared / count);
        EXPECT_GT(error, 0);
        EXPECT_LT(error, takes_root ? 0.4 : 0.15);
        // Dual resolution repairs the errors of half resolution.
        if (resolution == Resolution::dual) {
            EXPECT_LT(error, before);
        }
        before = error;
        // A tap of the coarse G-buffer lies up to a pixel beside its point, which a slope turns into
        // occlusion.
        const double beside = takes_root ? 0.19 : 0.04 * power;
        const double tolerance = resolution == Resolution::half_gbuffer ? beside : 0.02;
        EXPECT_NEAR(mean_over(image, surface), mean_over(full, surface), tolerance);
    }
}

// On two walls that meet, both seen at an angle, the upsampled picture follows their planes, without steps of
// the coarse pixels.
TEST(CoarsePicture, IsBroughtUpWithoutStripesOnASlope) {
    Scene scene = empty_scene();
    const glm::dvec3 corner(0.3, -3, -4.5), left(-0.6, 0, 0.8), right(0.8, 0, 0.6);
    for (const glm::dvec3& along : {left, right}) add_quad(scene, corner, 4.0 * along, {0, 6, 0});
    ScreenRenderer renderer;
    renderer.set_scene(scene);
    renderer.draw_gbuffer(CameraFrame(front_camera(), 320, 180), gbuffer_inputs());
    const auto methods = load_methods();
    MethodRequest request;
    request.method = &find_method(methods, "multi-resolution");
    request.parameters = request.method->values("default", {{"radius", 5.0}});
    const ImageF image = renderer.run(request).raw;
    write_png((output_dir() / "walls.png").string(), image);
    // The darkest pixels are the corner.
    int middle = 0;
    for (int x = 0; x < image.width; ++x) middle = image.at(x, 90) < image.at(middle, 90) ? x : middle;
    // Beside it visibility grows to 1, with steps that change gradually from pixel to pixel.
    double largest = 0, range = 0;
    for (int x = 40; x < image.width - 40; ++x) {
        if (std::abs(x - middle) < 6) continue;
        const auto at = [&](int i) { return static_cast<double>(image.at(i, 90)); };
        largest = std::max(largest, std::abs(at(x + 1) - 2 * at(x) + at(x - 1)));
        range = std::max(range, 1 - at(x));
    }
    EXPECT_GT(range, 0.2) << "the corner occludes";
    EXPECT_LT(largest, 0.03);
}

INSTANTIATE_TEST_SUITE_P(Methods, EveryResolution, ::testing::ValuesIn(method_ids()),
                         [](const auto& tested) { return test_name(tested.param); });

}  // namespace
}  // namespace aoscore::testing
