// `aoscore worst` on scenes where it is known which views are worst, and why.
#include "results/results.h"
#include "support/support.h"

#include <glm/glm.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace aoscore {
namespace {

using testing::output_dir;
using testing::ProgramRun;
using testing::run_aoscore;

struct Box {
    glm::dvec3 low, high;
};

/// Writes boxes, wound outwards, as an OBJ file.
void write_boxes(const std::filesystem::path& file, const std::vector<Box>& boxes) {
    constexpr int kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                  {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    std::ofstream out(file);
    for (const Box& box : boxes) {
        for (int i = 0; i < 8; ++i) {
            out << "v " << ((i & 1) != 0 ? box.high.x : box.low.x) << ' '
                << ((i & 2) != 0 ? box.high.y : box.low.y) << ' ' << ((i & 4) != 0 ? box.high.z : box.low.z)
                << '\n';
        }
        for (const auto& face : kFaces) {
            out << 'f';
            for (const int corner : face) out << ' ' << corner - 8;  // of the last eight vertices
            out << '\n';
        }
    }
}

/// The view that GTAO errs most on at a radius of 1 m, as the results of the search have it.
struct Worst {
    ViewRecord view;
    std::map<std::string, double> missing;  ///< parts of the picture with missing occlusion, by cause
    double area = 0;                        ///< their sum

    explicit Worst(const std::vector<Box>& boxes) {
        const auto folder = output_dir();
        write_boxes(folder / "made.obj", boxes);
        const ProgramRun run = run_aoscore(
            "worst made.obj --methods gtao --radius 1 --cameras 40 --count 1 --size 160x90 --samples 64 "
            "--out o",
            folder);
        EXPECT_EQ(run.exit_code, 0) << run.err;
        const Results results = read_results(folder / "o");
        view = results.views.at(0);
        for (const CauseShare& share : results.cells.at(0).analysis.value().missing.causes) {
            missing[share.cause] = share.area;
            area += share.area;
        }
        EXPECT_GT(area, 0.05);
    }
    glm::dvec3 position() const { return {view.position_m[0], view.position_m[1], view.position_m[2]}; }
    glm::dvec3 way() const {
        return glm::normalize(glm::dvec3(view.target_m[0], view.target_m[1], view.target_m[2]) - position());
    }
};

// A thin board stands on a floor. A camera in its plane sees neither of its faces, while the floor that they
// darken lies open on both sides.
TEST(WorstOfKnownScenes, IsEdgeOnToABoard) {
    const Worst worst({{{-3, -0.2, -3}, {3, 0, 3}}, {{-2, 0, -0.01}, {2, 1.5, 0.01}}});
    EXPECT_LT(std::abs(worst.position().z), 0.3) << "metres from the board's plane";
    EXPECT_LT(std::abs(worst.way().z), std::sin(glm::radians(10.0)));
    EXPECT_GT((worst.missing.at("hidden") + worst.missing.at("grazing")) / worst.area, 0.9);
}

// A panel stands close before a wall, and a larger screen before both: what darkens the wall is hidden from
// all cameras but those in the gap.
TEST(WorstOfKnownScenes, HasItsOccluderBehindWhatTheCameraSees) {
    const Worst worst({{{-5, -0.2, -1.2}, {5, 0, 5}},
                       {{-5, 0, -1.2}, {5, 4, -1}},
                       {{-1.8, 0, -0.62}, {1.8, 2.3, -0.6}},
                       {{-2, 0, 1.2}, {2, 2.5, 1.25}}});
    for (const auto& [cause, area] : worst.missing) {
        EXPECT_LE(area, worst.missing.at("hidden")) << cause;
    }
}

// Nothing hides in an empty room, and no wall turns away: what a camera misses lies outside of its picture.
TEST(WorstOfKnownScenes, HasItsOccluderOutsideOfThePictureInAnEmptyRoom) {
    const Worst worst({{{-6.2, -0.2, -6.2}, {6.2, 0, 6.2}},
                       {{-6.2, 5, -6.2}, {6.2, 5.2, 6.2}},
                       {{-6.2, 0, -6.2}, {-6, 5, 6.2}},
                       {{6, 0, -6.2}, {6.2, 5, 6.2}},
                       {{-6, 0, -6.2}, {6, 5, -6}},
                       {{-6, 0, 6}, {6, 5, 6.2}}});
    EXPECT_EQ(worst.missing.at("hidden"), 0);
    EXPECT_EQ(worst.missing.at("grazing"), 0);
    EXPECT_GT(worst.missing.at("outside"), worst.missing.at("visible"));
}

}  // namespace
}  // namespace aoscore
