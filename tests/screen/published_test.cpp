// Compares methods as published with their published mathematics in double precision, on the G-buffer of a
// scene's own view, at 1,000 random pixels; writes published.md.
#include "hand_made.h"
#include "published_methods.h"
#include "scene/scene.h"
#include "support/support.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <utility>

namespace aoscore::testing {
namespace {

using namespace published;

constexpr int kWidth = 240, kHeight = 136;
constexpr std::uint64_t kSeed = 1;
constexpr double kRadius = 0.5;
const double kTanHalf = std::tan(60 * std::numbers::pi / 360);  // of half the view's angle

const Kernel3& disc(int points) {
    static std::map<int, Kernel3> known;
    return known
        .try_emplace(
            points,
            points_of({"disc", std::to_string(points), "disc", "volume", "none", "low_discrepancy"}, kSeed))
        .first->second;
}

std::vector<glm::dvec2> disc_pattern(int points) {
    std::vector<glm::dvec2> pattern;
    for (const glm::dvec3& p : disc(points)) pattern.emplace_back(p.x, p.y);
    return pattern;
}

// Holds the G-buffer, drawn once for all cases.
struct Stage {
    Stage() {
        const Scene scene = load_scene("atrium");
        const auto view = std::find_if(scene.views.begin(), scene.views.end(),
                                       [](const View& v) { return v.id == "wide"; });
        const CameraFrame frame(view->camera, kWidth, kHeight);
        renderer.set_scene(scene);
        renderer.draw_gbuffer(frame, gbuffer_inputs());
        picture.emplace(frame, renderer.read_gbuffer());
    }
    ScreenRenderer renderer;
    std::optional<Picture> picture;
    std::vector<MethodDescriptor> methods = load_methods(), filters = load_filters();
};

struct PublishedCase {
    const char* name;
    const char* method;
    const char* preset;
    ParameterValues settings;
    std::function<Estimator(const Picture&)> estimator;
    /// The implementation's own filter; empty where it has none.
    std::function<ImageF(const Picture&, const ImageF&)> filter;
    /// The share of pixels that may differ by more than kNear, whose taps rounding pushes over a texel's
    /// edge.
    double share_off;
};

constexpr double kNear = 0.005;

const std::vector<PublishedCase>& cases() {
    static const std::vector<PublishedCase> all = {
        {"n8ao",
         "n8ao",
         "published",
         {},
         [](const Picture& p) { return n8ao(p, hash_noise(kSeed), kRadius, true); },
         [](const Picture& p, const ImageF& v) { return n8ao_denoised(p, hash_noise(kSeed), v, kRadius); },
         0.02},
        {"n8ao_default",
         "n8ao",
         "default",
         {},
         [](const Picture& p) { return n8ao(p, tiled_noise(kSeed), kRadius, false); },
         {},
         0.02},
        {"xegtao_high",
         "xegtao",
         "high",
         {},
         [](const Picture& p) { return xegtao(p, hilbert_noise(), kRadius, 3, 3); },
         xegtao_denoised,
         0.02},
        {"xegtao_low",
         "xegtao",
         "low",
         {},
         [](const Picture& p) { return xegtao(p, hilbert_noise(), kRadius, 1, 2); },
         xegtao_denoised,
         0.02},
        {"three_gtao",
         "three-gtao",
         "default",
         {{"radius", kRadius}, {"thickness", 4 * kRadius}},
         [](const Picture& p) { return three_gtao(p, kRadius, 4 * kRadius); },
         [](const Picture& p, const ImageF& v) { return three_denoised(p, hash_noise(kSeed), v, 2); },
         0.02},
        {"hbao_plus",
         "hbao-plus",
         "nvidia",
         {},
         [](const Picture& p) { return hbao_plus(p, tiled_noise(kSeed), kRadius); },
         hbao_plus_blurred,
         0.02},
        {"cacao",
         "cacao",
         "published",
         {{"radius", kRadius}},
         [](const Picture& p) { return cacao(p, disc_pattern(12), kRadius, kTanHalf); },
         cacao_blurred,
         0.02},
        {"godot_ssao",
         "cacao",
         "godot",
         {{"radius", kRadius}},
         [](const Picture& p) { return godot_ssao(p, disc_pattern(5), kRadius, kTanHalf); },
         {},
         0.02},
        {"sao", "sao", "published", {}, [](const Picture& p) { return sao(p, 1); }, sao_blurred, 0.02},
        {"filament_ssao",
         "filament-ssao",
         "published",
         {{"radius", kRadius}},
         [](const Picture& p) { return filament_ssao(p, kRadius); },
         filament_blurred,
         0.02},
        {"learnopengl_ssao",
         "ssao",
         "learnopengl",
         {},
         [](const Picture& p) {
             const Kernel3 kernel =
                 points_of({"points", "64", "hemisphere_cube", "uniform", "squared", "random"}, kSeed);
             return learnopengl_ssao(p, kernel, tiled_noise(kSeed), kRadius);
         },
         box_blurred,
         0.02},
        {"vermeer_ssao",
         "ssao",
         "published",
         {},
         [](const Picture& p) {
             const Kernel3 kernel =
                 points_of({"points", "16", "hemisphere", "volume", "none", "low_discrepancy"}, kSeed);
             return vermeer_ssao(p, kernel, hash_noise(kSeed), kRadius);
         },
         {},
         0.02},
        {"vermeer_hbao",
         "hbao",
         "published",
         {},
         [](const Picture& p) { return vermeer_hbao(p, hash_noise(kSeed), kRadius); },
         {},
         0.02},
        {"vermeer_hbao_plus",
         "hbao-plus",
         "published",
         {},
         [](const Picture& p) { return vermeer_hbao_plus(p, hash_noise(kSeed), kRadius); },
         {},
         0.02},
        {"vermeer_sd_ssao",
         "sd-ssao",
         "published",
         {},
         [](const Picture& p) {
             const Kernel3 kernel =
                 points_of({"points", "42", "hemisphere", "volume", "none", "low_discrepancy"}, kSeed);
             return vermeer_ssao(p, kernel, hash_noise(kSeed), kRadius);
         },
         {},
         0.02},
        {"vermeer_sd_hbao",
         "sd-hbao",
         "published",
         {},
         [](const Picture& p) {
             return vermeer_hbao(p, hash_noise(kSeed), kRadius, std::cos(66.5 * std::numbers::pi / 180));
         },
         {},
         0.02},
        {"vermeer_sd_hbao_plus",
         "sd-hbao-plus",
         "published",
         {},
         [](const Picture& p) { return vermeer_hbao_plus(p, hash_noise(kSeed), kRadius); },
         {},
         0.02},
        {"crytek_listing",
         "crytek-ssao",
         "listing",
         {},
         [](const Picture& p) {
             const Kernel3 kernel =
                 points_of({"points", "16", "sphere_cube", "uniform", "squared_of_64", "random"}, kSeed);
             return hussain_crytek(p, kernel, tiled_noise(kSeed), kRadius);
         },
         box_blurred,
         0.02},
        {"whinham_ssao",
         "hemisphere-ssao",
         "published",
         {{"radius", kRadius}},
         [](const Picture& p) {
             const Kernel3 kernel =
                 points_of({"points", "16", "hemisphere_cosine", "shell", "none", "random"}, kSeed);
             return whinham_ssao(p, kernel, tiled_noise(kSeed), kRadius);
         },
         box_blurred,
         0.02},
        {"alchemy_listing",
         "alchemy",
         "listing",
         {},
         [](const Picture& p) { return hussain_alchemy(p, disc(12), hash_noise(kSeed), kRadius); },
         box_blurred,
         0.02},
        {"alchemy_spiral",
         "alchemy-spiral",
         "published",
         {},
         [](const Picture& p) { return gravas_spiral(p, kRadius); },
         {},
         0.02},
        {"nvidia_hbao",
         "hbao",
         "nvidia",
         {},
         [](const Picture& p) { return nvidia_hbao(p, tiled_noise(kSeed), kRadius); },
         nvidia_hbao_blurred,
         0.02},
        {"unity_ssao",
         "unity-ssao",
         "published",
         {{"radius", kRadius / 1.5}},
         [](const Picture& p) { return unity_ssao(p, sample_numbers(8, kSeed), kSeed, kRadius / 1.5); },
         unity_blurred,
         0.02},
        {"unity_ssao_gradient",
         "unity-ssao",
         "interleaved-gradient",
         {{"radius", kRadius}},
         [](const Picture& p) { return unity_gradient_ssao(p, sample_numbers(8, kSeed), kRadius); },
         unity_blurred,
         0.02},
        {"visibility_bitmask",
         "visibility-bitmask",
         "published",
         {},
         [](const Picture& p) { return visibility_bitmask(p, hash_noise(kSeed), kRadius, kRadius / 5); },
         {},
         0.03},
    };
    return all;
}

// Chooses random pixels that show a surface.
std::vector<glm::ivec2> random_pixels(const Picture& picture) {
    std::mt19937_64 random(7);
    std::uniform_int_distribution<int> column(0, kWidth - 1), row(0, kHeight - 1);
    std::vector<glm::ivec2> chosen;
    while (chosen.size() < 1000) {
        const glm::ivec2 pixel(column(random), row(random));
        if (picture.surface(pixel.x, pixel.y)) chosen.push_back(pixel);
    }
    return chosen;
}

struct Distance {
    std::size_t off = 0, pixels = 0;
    double rmsd = 0, bias = 0;
};

// The shader's values less the expected ones, whose values above 1 read as 1.
Distance distance(const std::vector<glm::ivec2>& pixels, const ImageF& shader, const ImageF& expected) {
    Distance measured{.pixels = pixels.size()};
    double squares = 0, sum = 0;
    for (const glm::ivec2& p : pixels) {
        const double wanted = std::min(static_cast<double>(expected.at(p.x, p.y)), 1.0);
        const double difference = static_cast<double>(shader.at(p.x, p.y)) - wanted;
        measured.off += std::abs(difference) > kNear ? 1 : 0;
        squares += difference * difference;
        sum += difference;
    }
    const auto count = static_cast<double>(pixels.size());
    measured.rmsd = std::sqrt(squares / count);
    measured.bias = sum / count;
    return measured;
}

ImageF evaluated(const Picture& picture, const Estimator& estimate) {
    ImageF whole(kWidth, kHeight, 1.0F);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            if (picture.surface(x, y)) whole.at(x, y) = static_cast<float>(estimate(x, y));
        }
    }
    return whole;
}

// Draws every method as published, holds it against its implementation, and writes both distances: those of
// its default too, which need not be near.
class PublishedTable {
  public:
    explicit PublishedTable(std::filesystem::path folder)
        : folder_(std::move(folder)), pixels_(random_pixels(*stage_.picture)) {}

    void add(const PublishedCase& c) {
        const MethodOutput output = drawn(c, c.preset);
        write_png((folder_ / (std::string(c.name) + "_raw.png")).string(), output.raw);
        write_png((folder_ / (std::string(c.name) + ".png")).string(), output.visibility);
        // The layers are an input, like the depth: depth_layers_test.cpp tests the law by which they are
        // drawn.
        const bool layered = find_method(stage_.methods, c.method).depth_layers.has_value();
        stage_.picture->take_layers(layered ? stage_.renderer.read_depth_layers() : std::vector<ImageF>());
        const ImageF whole = evaluated(*stage_.picture, c.estimator(*stage_.picture));
        expect_near(c, "raw", output.raw, whole, c.share_off);
        if (c.filter) {
            expect_near(c, "filtered", output.visibility, c.filter(*stage_.picture, whole), 2 * c.share_off);
        }
        if (std::string_view(c.preset) != "default")
            add_row(c, "raw, by the preset default", distance(pixels_, drawn(c, "default").raw, whole));
    }

    void write() const {
        std::ofstream out(folder_ / "published.md");
        out << "| implementation | method | preset | picture | pixels off by more than " << kNear
            << " | rmsd | bias |\n|---|---|---|---|---:|---:|---:|\n"
            << rows_;
        ASSERT_TRUE(out.flush());
    }

  private:
    MethodOutput drawn(const PublishedCase& c, const char* preset) {
        MethodRequest request =
            request_for(find_method(stage_.methods, c.method), stage_.filters, preset, c.settings);
        request.seed = kSeed;
        return stage_.renderer.run(request);
    }

    void expect_near(const PublishedCase& c, const char* picture, const ImageF& shader,
                     const ImageF& expected, double share_off) {
        const Distance measured = distance(pixels_, shader, expected);
        add_row(c, picture, measured);
        EXPECT_LE(static_cast<double>(measured.off), share_off * static_cast<double>(measured.pixels))
            << c.name << ", " << picture;
        EXPECT_LT(measured.rmsd, 0.01) << c.name << ", " << picture;
    }

    void add_row(const PublishedCase& c, const char* picture, const Distance& measured) {
        rows_ += fmt::format("| {} | {} | {} | {} | {} of {} | {:.5f} | {:+.5f} |\n", c.name, c.method,
                             c.preset, picture, measured.off, measured.pixels, measured.rmsd, measured.bias);
    }

    std::filesystem::path folder_;
    Stage stage_;
    std::vector<glm::ivec2> pixels_;
    std::string rows_;
};

// The whole table is one test, so that it is written to one file: published.md.
TEST(Published, EachMethodAgreesWithItsImplementationInDoublePrecisionOnAScenesOwnView) {
    PublishedTable table(output_dir());
    for (const PublishedCase& c : cases()) table.add(c);
    table.write();
}

}  // namespace
}  // namespace aoscore::testing
