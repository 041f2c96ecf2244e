#pragma once

#include "gltf_file.h"

#include <cstdint>
#include <string>
#include <vector>

namespace aoscore::testing {

struct Grid {
    std::vector<float> positions;
    std::vector<std::uint32_t> indices;
};
/// A bumpy grid of n x n points over the unit square.
Grid grid(unsigned n);

/// The grid as a node's mesh, without compression.
GltfFile plain_file(const Grid& g);

/// Encodes streams by meshoptimizer.
std::vector<unsigned char> encoded_vertices(const void* data, std::size_t count, std::size_t stride);
std::vector<unsigned char> encoded_triangles(const Grid& g);

/// Adds a compressed buffer view over an empty second buffer; returns its index.
int add_compressed(GltfFile& file, const std::string& extension, const std::vector<unsigned char>& stream,
                   std::size_t stride, std::size_t count, const std::string& mode,
                   const std::string& filter = "NONE");

/// The grid with compressed attributes, and compressed indices as `mode`.
GltfFile compressed_file(const Grid& g, const std::string& extension, const std::string& mode = "TRIANGLES");

/// A stream of Draco's encoder, by one of its two codings.
std::string draco_stream(const Grid& g, int position_bits, bool edgebreaker);
/// A file with a primitive of that stream, whose accessors state so many vertices and corners.
GltfFile draco_file(const std::string& stream, std::size_t vertices, std::size_t corners);

}  // namespace aoscore::testing
