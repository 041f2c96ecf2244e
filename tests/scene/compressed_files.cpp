#include "compressed_files.h"

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <cmath>

namespace aoscore::testing {

using nlohmann::json;

Grid grid(unsigned n) {
    Grid result;
    for (unsigned y = 0; y < n; ++y) {
        for (unsigned x = 0; x < n; ++x) {
            const float u = static_cast<float>(x) / static_cast<float>(n - 1);
            const float v = static_cast<float>(y) / static_cast<float>(n - 1);
            result.positions.insert(result.positions.end(), {u, v, std::sin(7 * u) * std::cos(5 * v) / 8});
        }
    }
    for (unsigned y = 0; y + 1 < n; ++y) {
        for (unsigned x = 0; x + 1 < n; ++x) {
            const unsigned a = y * n + x;
            result.indices.insert(result.indices.end(), {a, a + 1, a + n, a + 1, a + n + 1, a + n});
        }
    }
    return result;
}

GltfFile plain_file(const Grid& g) {
    GltfFile file;
    const int positions = file.add_positions(g.positions);
    file.add_mesh(
        {{"attributes", {{"POSITION", positions}}}, {"indices", file.add_accessor(g.indices, "SCALAR", 1)}});
    file.add_node({{"mesh", 0}});
    return file;
}

int add_compressed(GltfFile& file, const std::string& extension, const std::vector<unsigned char>& stream,
                   std::size_t stride, std::size_t count, const std::string& mode,
                   const std::string& filter) {
    const int view = file.add_view(stream.data(), stream.size());
    json& members = file.document["bufferViews"][static_cast<std::size_t>(view)];
    members["extensions"][extension] = {{"buffer", 0},     {"byteOffset", members["byteOffset"]},
                                        {"count", count},  {"byteLength", stream.size()},
                                        {"mode", mode},    {"byteStride", stride},
                                        {"filter", filter}};
    members["buffer"] = 1;
    members["byteOffset"] = 0;
    members["byteLength"] = stride * count;
    return view;
}

std::vector<unsigned char> encoded_vertices(const void* data, std::size_t count, std::size_t stride) {
    std::vector<unsigned char> stream(meshopt_encodeVertexBufferBound(count, stride));
    stream.resize(meshopt_encodeVertexBuffer(stream.data(), stream.size(), data, count, stride));
    return stream;
}

std::vector<unsigned char> encoded_triangles(const Grid& g) {
    std::vector<unsigned char> stream(
        meshopt_encodeIndexBufferBound(g.indices.size(), g.positions.size() / 3));
    stream.resize(
        meshopt_encodeIndexBuffer(stream.data(), stream.size(), g.indices.data(), g.indices.size()));
    return stream;
}

GltfFile compressed_file(const Grid& g, const std::string& extension, const std::string& mode) {
    GltfFile file;
    file.document["extensionsUsed"] = file.document["extensionsRequired"] = {extension};
    const std::size_t vertices = g.positions.size() / 3;
    const int positions = add_compressed(file, extension, encoded_vertices(g.positions.data(), vertices, 12),
                                         12, vertices, "ATTRIBUTES");
    std::vector<unsigned char> stream = encoded_triangles(g);
    if (mode == "INDICES") {
        stream.resize(meshopt_encodeIndexSequenceBound(g.indices.size(), vertices));
        stream.resize(
            meshopt_encodeIndexSequence(stream.data(), stream.size(), g.indices.data(), g.indices.size()));
    }
    const int indices = add_compressed(file, extension, stream, 4, g.indices.size(), mode);
    file.document["accessors"] = {
        {{"bufferView", positions},
         {"componentType", 5126},
         {"count", vertices},
         {"type", "VEC3"},
         {"min", {0, 0, 0}},
         {"max", {1, 1, 1}}},
        {{"bufferView", indices}, {"componentType", 5125}, {"count", g.indices.size()}, {"type", "SCALAR"}}};
    file.add_mesh({{"attributes", {{"POSITION", 0}}}, {"indices", 1}});
    file.add_node({{"mesh", 0}});
    file.fallback = {{"byteLength", 1 << 20}, {"extensions", {{extension, {{"fallback", true}}}}}};
    return file;
}

std::string draco_stream(const Grid& g, int position_bits, bool edgebreaker) {
    draco::TriangleSoupMeshBuilder builder;
    const std::size_t faces = g.indices.size() / 3;
    builder.Start(static_cast<int>(faces));
    const int attribute = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    for (std::uint32_t i = 0; i < faces; ++i) {
        const float* corner[3];
        for (std::uint32_t k = 0; k < 3; ++k) corner[k] = &g.positions[std::size_t{3} * g.indices[3 * i + k]];
        builder.SetAttributeValuesForFace(attribute, draco::FaceIndex(i), corner[0], corner[1], corner[2]);
    }
    const auto mesh = builder.Finalize();
    draco::Encoder encoder;
    encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, position_bits);
    encoder.SetEncodingMethod(edgebreaker ? draco::MESH_EDGEBREAKER_ENCODING
                                          : draco::MESH_SEQUENTIAL_ENCODING);
    draco::EncoderBuffer buffer;
    EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
    return {buffer.data(), buffer.size()};
}

GltfFile draco_file(const std::string& stream, std::size_t vertices, std::size_t corners) {
    GltfFile file;
    file.document["extensionsUsed"] = file.document["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    const int view = file.add_view(stream.data(), stream.size());
    file.document["accessors"] = {{{"componentType", 5126},
                                   {"count", vertices},
                                   {"type", "VEC3"},
                                   {"min", {0, 0, 0}},
                                   {"max", {1, 1, 1}}},
                                  {{"componentType", 5125}, {"count", corners}, {"type", "SCALAR"}}};
    file.add_mesh(
        {{"attributes", {{"POSITION", 0}}},
         {"indices", 1},
         {"extensions",
          {{"KHR_draco_mesh_compression", {{"bufferView", view}, {"attributes", {{"POSITION", 0}}}}}}}});
    file.add_node({{"mesh", 0}});
    return file;
}

}  // namespace aoscore::testing
