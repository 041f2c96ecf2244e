// Tests stored truths: their keys, when they serve, and that no bit differs from tracing anew.
#include "store/truth/truth_cache.h"

#include "reference/integrator/tile.h"
#include "reference/test_scenes.h"
#include "store/code_digest.h"
#include "store/truth/cache_file.h"
#include "store/truth/entry_lock.h"
#include "store/truth/tile_codec.h"
#include "store/truth/tracing_help.h"
#include "support/support.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <fstream>
#include <functional>
#include <set>
#include <thread>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using testing::output_dir;

struct Room {
    Scene scene = testing::thicket();
    ReferenceScene reference{scene};
    fs::path folder = output_dir();
    TruthCache cache{folder};

    TruthRequest request(int samples = 16) const {
        TruthRequest r;
        r.scene_digest = "thicket";
        r.camera = testing::looking({2, 2, 3}, {0, 0.6, 0});
        r.width = 96;
        r.height = 64;
        r.queries = {
            {Falloff::binary, 0.5, 0}, {Falloff::quadratic, 2, 0}, {Falloff::alchemy, INFINITY, 0.2}};
        r.settings.samples = samples;
        return r;
    }
    CachedTruth get(const TruthRequest& r) const {
        return cache.trace(reference, r, {"thicket", "v", "c"}, "test");
    }
    Truth anew(const TruthRequest& r) const {
        return reference.trace(CameraFrame(r.camera, r.width, r.height), r.queries, r.settings, "anew");
    }
    /// The only file with this extension.
    fs::path file(const std::string& extension) const {
        fs::path found;
        for (const auto& entry : fs::recursive_directory_iterator(folder)) {
            if (entry.path().extension() == extension) {
                EXPECT_TRUE(found.empty()) << "more than one";
                found = entry.path();
            }
        }
        return found;
    }
};

void expect_same_bits(const Truth& a, const Truth& b) {
    EXPECT_EQ(a.queries, b.queries);
    for (std::size_t q = 0; q < a.queries.size(); ++q) {
        EXPECT_EQ(a.visibility[q].pixels, b.visibility[q].pixels) << q;
        EXPECT_EQ(a.standard_error[q].pixels, b.standard_error[q].pixels) << q;
    }
    for (std::size_t c = 0; c < kCauses; ++c)
        EXPECT_EQ(a.occlusion_by_cause[c].pixels, b.occlusion_by_cause[c].pixels);
    EXPECT_EQ(a.one_layer_bound.pixels, b.one_layer_bound.pixels);
    EXPECT_EQ(a.bent_normal.pixels, b.bent_normal.pixels);
    EXPECT_EQ(a.bent_error_rad.pixels, b.bent_error_rad.pixels);
    EXPECT_EQ(a.cone_angle_rad.pixels, b.cone_angle_rad.pixels);
    EXPECT_EQ(a.cone_error_rad.pixels, b.cone_error_rad.pixels);
    EXPECT_EQ(a.hits.surface.pixels, b.hits.surface.pixels);
    EXPECT_EQ(a.hits.depth.pixels, b.hits.depth.pixels);
    EXPECT_EQ(a.hits.normal.pixels, b.hits.normal.pixels);
    EXPECT_EQ(a.sample_counts.pixels, b.sample_counts.pixels);
    EXPECT_EQ(a.rays, b.rays);
    EXPECT_EQ(a.open_pixels, b.open_pixels);
    EXPECT_EQ(a.samples, b.samples);
}

TEST(KeptTruths, NeedNoSceneBuiltForTracing) {
    const Room room;
    const Truth traced = room.get(room.request()).truth;
    const ReferenceScene unbuilt = ReferenceScene::built_when_needed(room.scene);
    const CachedTruth kept = room.cache.trace(unbuilt, room.request(), {"thicket", "v", "c"}, "test");
    EXPECT_EQ(kept.origin, TruthOrigin::cached);
    EXPECT_EQ(kept.truth.visibility[0].pixels, traced.visibility[0].pixels);
    EXPECT_EQ(unbuilt.peak_bytes(), 0u);
    // The scene is built as soon as it is needed.
    EXPECT_EQ(unbuilt.primary_hits(CameraFrame(room.request().camera, 96, 64)).depth.pixels,
              traced.hits.depth.pixels);
    EXPECT_GT(unbuilt.peak_bytes(), 0u);
}

TEST(CacheKey, ChangesWithEveryIngredient) {
    const std::vector<std::pair<const char*, std::function<void(TruthRequest&)>>> changes{
        {"nothing", [](TruthRequest&) {}},
        {"scene", [](TruthRequest& r) { r.scene_digest += "x"; }},
        {"projection", [](TruthRequest& r) { r.camera.projection = Camera::Projection::orthographic; }},
        {"position", [](TruthRequest& r) { r.camera.position.x = std::nextafter(r.camera.position.x, 9); }},
        {"target", [](TruthRequest& r) { r.camera.target.y += 1e-12; }},
        {"up", [](TruthRequest& r) { r.camera.up.z += 0.1; }},
        {"fovy", [](TruthRequest& r) { r.camera.fovy_rad += 1e-9; }},
        {"half height", [](TruthRequest& r) { r.camera.half_height += 1; }},
        {"near", [](TruthRequest& r) { r.camera.near *= 2; }},
        {"far", [](TruthRequest& r) { r.camera.far *= 2; }},
        {"width", [](TruthRequest& r) { ++r.width; }},
        {"height", [](TruthRequest& r) { ++r.height; }},
        {"radius", [](TruthRequest& r) { r.queries[0].radius_m = 0.6; }},
        {"endless radius", [](TruthRequest& r) { r.queries[0].radius_m = INFINITY; }},
        {"falloff", [](TruthRequest& r) { r.queries[0].falloff = Falloff::xegtao; }},
        {"u", [](TruthRequest& r) { r.queries[2].u_m = 0.3; }},
        {"one more query",
         [](TruthRequest& r) {
             r.queries.push_back({Falloff::binary, 3, 0});
         }},
        {"samples", [](TruthRequest& r) { ++r.settings.samples; }},
        {"error", [](TruthRequest& r) { r.settings.max_error = 0.01; }},
        {"seed", [](TruthRequest& r) { ++r.settings.seed; }},
        {"shading normals", [](TruthRequest& r) { r.settings.shading_normals = true; }},
        {"points", [](TruthRequest& r) { r.settings.points = PointKind::independent; }},
        {"causes", [](TruthRequest& r) { r.settings.extras.causes = true; }},
        {"bound", [](TruthRequest& r) { r.settings.extras.one_layer_bound = true; }},
        {"bent normals", [](TruthRequest& r) { r.settings.extras.bent_normals = true; }},
        {"skipping", [](TruthRequest& r) { r.settings.skip_open = false; }},
        {"build", [](TruthRequest& r) { r.build.baked_triangles_at_most = 0; }},
    };
    TruthRequest plain;
    plain.camera = testing::looking({2, 2, 3}, {0, 0.6, 0});
    plain.queries = {{Falloff::binary, 0.5, 0}, {Falloff::quadratic, 2, 0}, {Falloff::alchemy, 1, 0.2}};
    std::set<std::string> keys;
    for (const auto& [what, change] : changes) {
        TruthRequest request = plain;
        change(request);
        EXPECT_TRUE(keys.insert(request.picture_key() + request.wanted_key()).second) << what;
    }
    EXPECT_EQ(plain.picture().at("code"), code_digest("truth"));
    EXPECT_EQ(plain.picture().at("tracer"), tracer_version());
}

TEST(Cache, GivesBackEveryBit) {
    const Room room;
    TruthRequest request = room.request();
    request.settings.extras = {true, true, true};
    const CachedTruth first = room.get(request), second = room.get(request);
    EXPECT_EQ(first.origin, TruthOrigin::traced);
    EXPECT_EQ(second.origin, TruthOrigin::cached);
    EXPECT_EQ(second.truth.rays_now, 0U);
    expect_same_bits(first.truth, second.truth);
    expect_same_bits(first.truth, room.anew(request));
}

TEST(Cache, ATruthOfMoreServesARequestForLess) {
    const Room room;
    TruthRequest large = room.request(64);
    large.settings.extras = {true, true, false};
    const CachedTruth traced = room.get(large);

    TruthRequest fewer = room.request(16);
    fewer.queries = {large.queries[2], large.queries[0]};
    const CachedTruth served = room.get(fewer);
    EXPECT_EQ(served.origin, TruthOrigin::cached);
    EXPECT_EQ(served.made_for.settings.samples, 64) << "the samples really used are said";
    EXPECT_EQ(served.truth.samples, 64);
    ASSERT_EQ(served.truth.queries, fewer.queries);
    EXPECT_EQ(served.truth.visibility[0].pixels, traced.truth.visibility[2].pixels);
    EXPECT_EQ(served.truth.visibility[1].pixels, traced.truth.visibility[0].pixels);
    EXPECT_TRUE(served.truth.occlusion_by_cause[0].empty()) << "what was not asked for is not there";

    TruthRequest other_causes = fewer;
    other_causes.settings.extras.causes = true;
    EXPECT_FALSE(serves(large, other_causes)) << "causes are those of the first query";
    TruthRequest more = room.request(65);
    EXPECT_FALSE(serves(large, more));
    TruthRequest sure = room.request(16);
    sure.settings.max_error = 0.05;
    EXPECT_FALSE(serves(large, sure)) << "a fixed count promises no error";
    TruthRequest surer = sure;
    surer.settings.max_error = 0.02;
    EXPECT_TRUE(serves(surer, sure));
    EXPECT_FALSE(serves(sure, surer));
    EXPECT_TRUE(serves(surer, room.request(64))) << "begins with 96 rays everywhere";
    EXPECT_FALSE(serves(surer, room.request(512)));
    TruthRequest in_the_mean = room.request(16);
    in_the_mean.settings.mean_error = 0.05;
    EXPECT_TRUE(serves(surer, in_the_mean)) << "every pixel has that error, so has the mean";
    EXPECT_FALSE(serves(in_the_mean, surer));
    EXPECT_FALSE(serves(large, in_the_mean));
    TruthRequest surer_in_the_mean = in_the_mean;
    surer_in_the_mean.settings.mean_error = 0.02;
    EXPECT_TRUE(serves(surer_in_the_mean, in_the_mean));
    EXPECT_FALSE(serves(in_the_mean, surer_in_the_mean));
    TruthRequest another = room.request(16);
    another.queries.push_back({Falloff::binary, 3, 0});
    EXPECT_FALSE(serves(large, another));
}

TEST(Cache, RefiningGivesTheBitsOfTracingAllAtOnce) {
    const auto adaptive = [](TruthRequest r, double error) {
        r.settings.max_error = error;
        return r;
    };
    const Room room;
    TruthRequest plain = room.request(16);
    plain.settings.extras = {true, true, true};
    TruthRequest more = plain;
    more.settings.samples = 80;
    std::vector<TruthRequest> steps{plain, more, adaptive(more, 0.02), adaptive(more, 0.012)};
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const CachedTruth got = room.get(steps[i]);
        EXPECT_EQ(got.origin, i == 0 ? TruthOrigin::traced : TruthOrigin::refined) << i;
        const Truth anew = room.anew(steps[i]);
        expect_same_bits(got.truth, anew);
        if (i > 0) {
            EXPECT_LT(got.truth.rays_now, anew.rays) << i << ": what was there is not traced again";
        }
        EXPECT_EQ(room.cache.list().size(), 1U) << "what is served by the better one is removed";
    }
}

TEST(Cache, RefiningToAMeanErrorGivesTheBitsOfTracingAllAtOnce) {
    const Room room;
    TruthRequest request = room.request(16);
    request.settings.extras = {true, true, true};
    room.get(request);
    request.settings.samples = 32;
    request.settings.mean_error = 0.02;
    const CachedTruth got = room.get(request);
    EXPECT_EQ(got.origin, TruthOrigin::refined);
    const Truth anew = room.anew(request);
    expect_same_bits(got.truth, anew);
    EXPECT_LT(got.truth.rays_now, anew.rays_now);
    EXPECT_EQ(room.get(request).origin, TruthOrigin::cached);
}

TEST(Cache, ATornPartIsThrownAwayAndTheRestTakenOver) {
    const Room room;
    const TruthRequest request = room.request();
    const CachedTruth whole = room.get(request);
    const fs::path complete = room.file(".truth");
    const fs::path partial = fs::path(complete).replace_extension(".partial");
    const auto size = fs::file_size(complete);
    for (const double share : {0.3, 0.6, 0.9999}) {
        fs::rename(complete, partial);
        fs::resize_file(partial, static_cast<std::uintmax_t>(share * static_cast<double>(size)));
        ::testing::internal::CaptureStderr();
        const CachedTruth again = room.get(request);
        const std::string said = ::testing::internal::GetCapturedStderr();
        EXPECT_NE(said.find("thrown away"), std::string::npos) << said;
        EXPECT_EQ(again.origin, TruthOrigin::resumed) << share;
        EXPECT_LT(again.truth.rays_now, whole.truth.rays) << share;
        expect_same_bits(whole.truth, again.truth);
    }
}

TEST(Cache, DamageIsFoundWhereverItIs) {
    const Room room;
    const TruthRequest request = room.request();
    const CachedTruth whole = room.get(request);
    const fs::path complete = room.file(".truth");
    for (const double place : {0.0, 0.001, 0.25, 0.5, 0.75, 0.9999}) {
        {
            std::fstream file(complete, std::ios::in | std::ios::out | std::ios::binary);
            const auto at = static_cast<std::streamoff>(place * static_cast<double>(fs::file_size(complete)));
            file.seekg(at);
            const int byte = file.get();
            file.seekp(at);
            file.put(static_cast<char>(byte ^ 0x10));
        }
        ::testing::internal::CaptureStderr();
        const CachedTruth again = room.get(request);
        const std::string said = ::testing::internal::GetCapturedStderr();
        EXPECT_NE(said.find("thrown away"), std::string::npos) << place << said;
        EXPECT_NE(again.origin, TruthOrigin::cached) << place;
        expect_same_bits(whole.truth, again.truth);
        EXPECT_EQ(room.get(request).origin, TruthOrigin::cached) << place << ": whole again";
    }
}

TEST(Cache, SurvivesBeingKilledAnywhereWithoutADifferentBit) {
    const Room room;
    TruthRequest request = room.request(256);
    request.settings.extras = {true, true, false};
    const Truth undisturbed = room.anew(request);
    const fs::path folder = room.folder / request.picture_key();
    setenv("AOSCORE_TEST_CACHE", room.folder.c_str(), 1);
    for (const std::uintmax_t enough : {1U, 200'000U}) {
        // The child runs the test program anew, and so has none of the parent's threads.
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            execl("/proc/self/exe", "test_reference", "--gtest_also_run_disabled_tests",
                  "--gtest_filter=CacheChild.*", nullptr);
            _exit(127);
        }
        const fs::path partial = folder / (request.wanted_key() + ".partial");
        std::error_code ec;
        int status = 0;
        while (waitpid(child, &status, WNOHANG) == 0) {
            if (const auto size = fs::file_size(partial, ec); !ec && size > enough + 2000) break;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        kill(child, SIGKILL);
        waitpid(child, &status, 0);
        ASSERT_TRUE(fs::exists(partial)) << "killed in the middle";
    }
    const CachedTruth resumed = room.get(request);
    EXPECT_EQ(resumed.origin, TruthOrigin::resumed);
    EXPECT_LT(resumed.truth.rays_now, undisturbed.rays);
    expect_same_bits(undisturbed, resumed.truth);
    expect_same_bits(undisturbed, room.get(request).truth);
}

// This is no test, but the process that the test above kills.
TEST(CacheChild, DISABLED_Traces) {
    const char* folder = std::getenv("AOSCORE_TEST_CACHE");
    ASSERT_NE(folder, nullptr);
    const Scene scene = testing::thicket();
    const ReferenceScene reference(scene);
    TruthRequest r;
    r.scene_digest = "thicket";
    r.camera = testing::looking({2, 2, 3}, {0, 0.6, 0});
    r.width = 96;
    r.height = 64;
    r.queries = {{Falloff::binary, 0.5, 0}, {Falloff::quadratic, 2, 0}, {Falloff::alchemy, INFINITY, 0.2}};
    r.settings.samples = 256;
    r.settings.extras = {true, true, false};
    TruthCache(folder).trace(reference, r, {"thicket", "v", "c"}, "child");
}

TEST(Cache, TwoWhoWantTheSameTraceItOnce) {
    const Room room;
    const TruthRequest request = room.request(64);
    std::vector<CachedTruth> got(2);
    std::vector<std::thread> threads;
    for (CachedTruth& truth : got) threads.emplace_back([&] { truth = room.get(request); });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ((got[0].origin == TruthOrigin::cached) + (got[1].origin == TruthOrigin::cached), 1)
        << "the second waits for the first";
    expect_same_bits(got[0].truth, got[1].truth);
}

/// The help for a truth of the room, and its chunk in the middle with what tracing gives for it.
struct HelpedChunk {
    HelpedChunk(const Room& room, const TruthRequest& request)
        : stem(room.folder / request.picture_key() / request.wanted_key()),
          help(stem, TileGroups(request.width, request.height).count()),
          chunk(help.chunks() / 2),
          states(room.reference.trace_groups(CameraFrame(request.camera, request.width, request.height),
                                             request.queries, request.settings, help.groups_of(chunk))) {
        fs::create_directories(stem.parent_path());
    }
    std::uint64_t rays() const {
        std::uint64_t sum = 0;
        for (const GroupState& group : states) {
            for (const TileState& tile : group.tiles) {
                for (const std::uint32_t count : tile.samples) sum += count;
            }
        }
        return sum;
    }

    fs::path stem;
    TracingHelp help;
    std::size_t chunk;
    std::vector<GroupState> states;
};

TEST(Help, ThatWasPublishedIsTakenOverWithoutARayMore) {
    const Room room;
    for (const std::uint64_t seed : {1, 2}) {
        TruthRequest request = room.request(64);
        request.settings.seed = seed;
        const HelpedChunk helped(room, request);
        ASSERT_GT(helped.help.chunks(), 3u);
        ASSERT_GT(helped.rays(), 0u);
        helped.help.publish(helped.chunk, helped.states);
        const CachedTruth got = room.get(request);
        const Truth anew = room.anew(request);
        expect_same_bits(got.truth, anew);
        EXPECT_EQ(got.truth.rays_now, anew.rays_now - helped.rays());
    }
    EXPECT_TRUE(room.file(".help").empty());
    EXPECT_TRUE(room.file(".claim").empty());
}

TEST(Help, ThatIsDamagedOrNeverComesCostsNoBit) {
    const Room room;
    for (const bool damaged : {true, false}) {
        TruthRequest request = room.request(16);
        request.settings.seed = damaged ? 3 : 4;
        const HelpedChunk helped(room, request);
        ASSERT_TRUE(helped.help.claim(helped.chunk));
        EXPECT_FALSE(helped.help.claim(helped.chunk)) << "another process could begin it too";
        if (damaged) {
            helped.help.publish(helped.chunk, helped.states);
            std::fstream file(room.file(".help"), std::ios::in | std::ios::out | std::ios::binary);
            file.seekp(200);
            file << "damage";
        }
        const CachedTruth got = room.get(request);
        const Truth anew = room.anew(request);
        expect_same_bits(got.truth, anew);
        EXPECT_EQ(got.truth.rays_now, anew.rays_now);
    }
}

TEST(Help, OfOneWhoWaitsIsAllThatIsLeftToTrace) {
    const Room room;
    const TruthRequest request = room.request(64);
    const HelpedChunk helped(room, request);
    CachedTruth got;
    std::thread waiting;
    {
        // Somebody has the truth and traces nothing, until the one who waits has traced all chunks.
        const EntryLock lock = EntryLock::acquire(fs::path(helped.stem) += ".lock", [] {});
        waiting = std::thread([&] { got = room.get(request); });
        for (std::size_t chunk = 0; chunk < helped.help.chunks(); ++chunk) {
            while (!helped.help.published(chunk)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
    waiting.join();
    expect_same_bits(got.truth, room.anew(request));
    EXPECT_EQ(got.truth.rays_now, 0u) << "the lock was free when all was there";
    EXPECT_TRUE(room.file(".help").empty());
}

TEST(Cache, ClearSaysWhatItFreedAndLeavesWhatIsInUse) {
    const Room room;
    room.get(room.request());
    TruthRequest other = room.request();
    other.settings.seed = 2;
    room.get(other);
    const fs::path in_use = room.folder / other.picture_key() / (other.wanted_key() + ".lock");
    {
        const EntryLock lock = EntryLock::acquire(in_use, [] {});
        EXPECT_FALSE(EntryLock::try_acquire(in_use));
        const ClearedCache cleared = room.cache.clear();
        EXPECT_EQ(cleared.files, 1U);
        EXPECT_GT(cleared.bytes, 1000U);
        EXPECT_EQ(cleared.kept_in_use, 1U);
        EXPECT_EQ(room.cache.list().size(), 1U);
    }
    EXPECT_EQ(room.cache.clear().files, 1U);
    EXPECT_TRUE(fs::is_empty(room.folder)) << "nothing is left behind";
}

TEST(Cache, AFolderThatCannotBeWrittenCostsNoTruth) {
    const Room room;
    std::ofstream(room.folder / "file") << "in the way";
    ::testing::internal::CaptureStderr();
    const CachedTruth truth =
        TruthCache(room.folder / "file").trace(room.reference, room.request(), {"s", "v", "c"}, "test");
    EXPECT_NE(::testing::internal::GetCapturedStderr().find("not kept"), std::string::npos);
    EXPECT_EQ(truth.origin, TruthOrigin::traced);
    expect_same_bits(truth.truth, room.anew(room.request()));
}

TEST(TileCodec, LosesNothingAndRefusesWhatItDidNotMake) {
    const Room room;
    TruthRequest request = room.request(7);
    request.settings.extras = {true, true, true};
    const std::vector<GroupState> states =
        room.reference.trace_groups(CameraFrame(request.camera, request.width, request.height),
                                    request.queries, request.settings, {0, 3});
    for (const GroupState& state : states) {
        const std::string bytes = encode(state);
        EXPECT_EQ(decode(bytes, "here").tiles, state.tiles);
        for (std::size_t size = 0; size < bytes.size(); size += 97)
            EXPECT_THROW(decode(bytes.substr(0, size), "here"), std::exception) << size;
    }
}

}  // namespace
}  // namespace aoscore
