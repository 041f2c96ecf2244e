#include "reference/tracer/cell_packets.h"

#include "core/sampling.h"
#include "reference/integrator/tile_tracer.h"
#include "reference/test_scenes.h"
#include "reference/tile_points.h"
#include "reference/tracer/ray_tracer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

namespace aoscore {
namespace {

/// A floor and two walls: hemispheres of three kinds in one tile, the fewest of them too few for packets.
std::vector<RaySource> points_of_a_corner(const RayTracer& scene) {
    return testing::tile_points(scene, [](std::uint64_t i) {
        return i < 27 ? glm::dvec3(0, 1, 0) : i < 56 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
    });
}

TEST(PointCells, HoldOnePointEachHoweverTheyAreShifted) {
    const PointSets points(PointKind::scrambled_sobol, 1024);
    for (const auto& [first, size] :
         {std::array{0, 128}, {0, 1024}, {256, 256}, {96, 32}, {512, 512}, {5, 1}}) {
        const PointCells cells(points, first, size);
        for (std::size_t set = 0; set < PointSets::kSets; ++set) {
            const std::uint64_t shifts = mix_bits(set + 77);
            const auto shift_u = static_cast<std::uint32_t>(shifts),
                       shift_v = static_cast<std::uint32_t>(shifts >> 32);
            std::vector<int> found(static_cast<std::size_t>(size));
            for (int c = 0; c < size; ++c) {
                const std::uint64_t word =
                    cells.points()[set * static_cast<std::size_t>(size) + static_cast<std::size_t>(c)];
                const auto number = static_cast<std::size_t>(first) + word_number(word);
                EXPECT_EQ(word_u(word), points.set(set).u[number] >> 9 << 9);
                EXPECT_EQ(word_v(word), points.set(set).v[number] >> 9 << 9);
                const std::uint64_t shifted = word ^ point_word(shift_u, shift_v, 0);
                EXPECT_EQ(cells.cell(word_u(shifted), word_v(shifted)),
                          static_cast<std::uint32_t>(c) ^ cells.cell(shift_u, shift_v));
                ++found[word_number(word)];
            }
            EXPECT_EQ(std::ranges::count(found, 1), size);
        }
    }
}

TEST(PointCells, ComeInNetsThatBeginAtMultiplesOfTheirSize) {
    EXPECT_EQ(net_after(0, 256), 256);
    EXPECT_EQ(net_after(0, 200), 128);
    EXPECT_EQ(net_after(128, 200), 64);
    EXPECT_EQ(net_after(192, 200), 8);
    EXPECT_EQ(net_after(96, 512), 32);
}

TEST(CellPackets, HoldTheVeryRaysThatAreSortedOtherwise) {
    const auto scene = new_ray_tracer(testing::thicket(), {});
    const std::vector<RaySource> sources = points_of_a_corner(*scene);
    const PointSets points(PointKind::scrambled_sobol, 512);
    const auto words = [](float x, float y, float z, std::uint32_t owner) {
        return std::array{std::bit_cast<std::uint32_t>(x), std::bit_cast<std::uint32_t>(y),
                          std::bit_cast<std::uint32_t>(z), owner};
    };
    for (const RayDensity density : {RayDensity::cosine, RayDensity::uniform}) {
        for (const std::size_t pixels : {std::size_t{16}, std::size_t{23}, std::size_t{32}}) {
            const PointCells cells(points, 256, 256);
            CellPackets packets;
            RayBatch batch(points, density);
            packets.start(cells, density, 64);
            batch.clear();
            for (std::size_t s = 0; s < pixels; ++s) {
                packets.add(sources[s], static_cast<std::uint32_t>(s * kBlocks));
                batch.add(sources[s], s, 256, 512, 64);
            }
            packets.close();
            ASSERT_EQ(packets.size(), batch.size());
            std::vector<std::array<std::uint32_t, 4>> made, expected;
            for (std::size_t first = 0; first < packets.size(); first += kPacket) {
                RayPacket packet;
                packets.fill(packet, first);
                for (std::size_t lane = 0; lane < std::min(kPacket, packets.size() - first); ++lane)
                    made.push_back(words(packet.direction_x[lane], packet.direction_y[lane],
                                         packet.direction_z[lane], packet.id[lane]));
            }
            for (std::size_t i = 0; i < batch.size(); ++i) {
                const DirectedRay& ray = batch.rays()[i];
                expected.push_back(words(ray.x, ray.y, ray.z, ray.owner));
            }
            std::ranges::sort(made);
            std::ranges::sort(expected);
            EXPECT_EQ(made, expected) << pixels << " pixels";
        }
    }
}

TEST(CellPackets, GiveATileTheSumsThatSortedRaysGive) {
    const auto scene = new_ray_tracer(testing::thicket(), {});
    for (const double radius_m : {0.05 * scene->diagonal_m(), 1000.0}) {
        for (const Falloff falloff : {Falloff::binary, Falloff::quadratic}) {
            const std::vector<TruthQuery> queries = {{falloff, radius_m, 0}};
            const PointSets points(PointKind::scrambled_sobol, 400);
            TileTracer by_cells(*scene, queries, points, true), sorted(*scene, queries, points, true);
            const std::vector<RaySource> sources = points_of_a_corner(*scene);
            by_cells.start(sources);
            by_cells.trace(std::vector<SampleRange>(sources.size(), {0, 400}));
            sorted.start(sources);
            for (int first = 0; first < 400; first += 16)
                sorted.trace(std::vector<SampleRange>(sources.size(), {first, first + 16}));
            EXPECT_EQ(by_cells.rays(), sorted.rays());
            double blocked = 0;
            for (std::size_t s = 0; s < sources.size(); ++s) {
                EXPECT_TRUE(std::ranges::equal(by_cells.sums(s, 0), sorted.sums(s, 0))) << s;
                for (const double sum : sorted.sums(s, 0)) blocked += sum;
            }
            EXPECT_GT(blocked, 100) << "there is something to find";
        }
    }
}

}  // namespace
}  // namespace aoscore
