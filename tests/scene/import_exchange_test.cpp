#include "core/processes/child_process.h"
#include "scene/import/plain_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <limits>
#include <random>
#include <string>

namespace {

using aoscore::ChildProcess;
using aoscore::imported::PlainScene;

PlainScene sample() {
    PlainScene plain;
    plain.metres_per_unit = 0.01;
    plain.states_axes = true;
    aoscore::Scene& scene = plain.scene;
    scene.warnings = {"one", "two"};
    scene.textures.push_back({aoscore::Image<glm::u8vec4>(3, 2, glm::u8vec4(7))});
    scene.materials.push_back(
        {.name = "leaf", .base_color = glm::vec4(0.5f), .texture = 0, .alpha_cutoff = 0.5f});
    aoscore::Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.texcoords = {{0, 0}, {1, 0}, {0, 1}};
    mesh.triangles = {{0, 1, 2}};
    scene.meshes.push_back(mesh);
    scene.instances.push_back({0, glm::dmat4(2.0)});
    scene.instances.back().scene_from_mesh[3][3] = 1;
    return plain;
}

std::string bytes_of(const PlainScene& plain) {
    std::string bytes;
    aoscore::imported::write_plain_scene(plain, [&](const void* data, std::size_t size) {
        bytes.append(static_cast<const char*>(data), size);
    });
    return bytes;
}

std::optional<PlainScene> read(const std::string& bytes) {
    std::size_t at = 0;
    return aoscore::imported::read_plain_scene([&](void* to, std::size_t size) {
        const std::size_t count = std::min({size, bytes.size() - at, std::size_t{13}});
        std::memcpy(to, bytes.data() + at, count);
        at += count;
        return count;
    });
}

TEST(HandedOverScene, ArrivesAsItWasSent) {
    const PlainScene sent = sample();
    const auto got = read(bytes_of(sent));
    ASSERT_TRUE(got.has_value());
    EXPECT_EQ(bytes_of(*got), bytes_of(sent));
    EXPECT_EQ(got->scene.meshes[0].positions, sent.scene.meshes[0].positions);
    EXPECT_EQ(got->scene.materials[0].name, "leaf");
    EXPECT_EQ(got->metres_per_unit, 0.01);
}

TEST(HandedOverScene, ThatBreaksOffAnywhereIsNone) {
    const std::string bytes = bytes_of(sample());
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_FALSE(read(bytes.substr(0, size)).has_value()) << size;
}

TEST(HandedOverScene, WithAFaultIsNone) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    const auto with = [](auto change) {
        PlainScene plain = sample();
        change(plain);
        return read(bytes_of(plain)).has_value();
    };
    EXPECT_TRUE(with([](PlainScene&) {}));
    EXPECT_FALSE(with([](PlainScene& p) { p.scene.meshes[0].triangles[0].z = 3; }));
    EXPECT_FALSE(with([](PlainScene& p) { p.scene.meshes[0].positions[1].y = kNan; }));
    EXPECT_FALSE(with([](PlainScene& p) { p.scene.meshes[0].texcoords[1].y = kNan; }));
    EXPECT_FALSE(with([](PlainScene& p) { p.scene.meshes[0].texcoords.clear(); }));
    EXPECT_FALSE(with([](PlainScene& p) { p.scene.meshes[0].normals.resize(2); }));
    EXPECT_FALSE(with([](PlainScene& p) { p.scene.meshes[0].material = 1; }));
    EXPECT_FALSE(with([](PlainScene& p) { p.scene.meshes[0].triangles.clear(); }));
    EXPECT_FALSE(with([](PlainScene& p) { p.scene.materials[0].texture = 1; }));
    EXPECT_FALSE(with([](PlainScene& p) { p.scene.materials[0].alpha_cutoff = 2; }));
    EXPECT_FALSE(with([](PlainScene& p) { p.scene.materials[0].base_color.r = kNan; }));
    EXPECT_FALSE(with([](PlainScene& p) { p.scene.textures[0].texels.width = 9; }));
    EXPECT_FALSE(with([](PlainScene& p) { p.scene.textures[0].texels.pixels.pop_back(); }));
    EXPECT_FALSE(with([](PlainScene& p) { p.scene.instances[0].mesh = -1; }));
    EXPECT_FALSE(with([](PlainScene& p) { p.scene.instances[0].scene_from_mesh[1][1] = 1.0 / 0.0; }));
    EXPECT_FALSE(with([](PlainScene& p) { p.scene.instances[0].scene_from_mesh[3][3] = 0; }));
    EXPECT_FALSE(with([](PlainScene& p) { p.metres_per_unit = -1; }));
}

TEST(HandedOverScene, OfSpoiledBytesIsSoundOrNone) {
    const std::string original = bytes_of(sample());
    std::mt19937 random(3);
    std::size_t sound = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        std::string bytes = original;
        for (int edit = 0; edit < 3; ++edit) bytes[random() % bytes.size()] = static_cast<char>(random());
        if (const auto got = read(bytes)) {
            ++sound;
            for (const aoscore::Mesh& mesh : got->scene.meshes) {
                for (const glm::uvec3& t : mesh.triangles)
                    ASSERT_LT(std::max({t.x, t.y, t.z}), mesh.positions.size());
            }
        }
    }
    EXPECT_GT(sound, 0u);
    EXPECT_LT(sound, 20000u);
}

ChildProcess::End end_of(const std::string& script) {
    ChildProcess child("/bin/sh", {"-c", script});
    char byte = 0;
    while (child.read(&byte, 1) > 0) {
    }
    return child.wait();
}

TEST(ChildProcesses, EndIsToldApartAndOutputArrives) {
    EXPECT_EQ(end_of("exit 3").exit_code, 3);
    EXPECT_EQ(end_of("kill -SEGV $$").signal, SIGSEGV);
    EXPECT_EQ(end_of("ulimit -St 1; while :; do :; done").signal, SIGXCPU);
    ChildProcess child("/bin/sh", {"-c", "printf hello"});
    char text[6] = {};
    std::size_t size = 0;
    while (const std::size_t count = child.read(text + size, 5 - std::min<std::size_t>(size, 4)))
        size += count;
    EXPECT_STREQ(text, "hello");
}

TEST(ChildProcesses, AreKilledWithTheObject) {
    pid_t pid = 0;
    {
        ChildProcess child("/bin/sh", {"-c", "echo $$; exec sleep 1000"});
        std::string text;
        for (char byte = 0; child.read(&byte, 1) > 0 && byte != '\n';) text += byte;
        pid = std::stoi(text);
        EXPECT_EQ(kill(pid, 0), 0);
    }
    EXPECT_NE(kill(pid, 0), 0);
}

}  // namespace
