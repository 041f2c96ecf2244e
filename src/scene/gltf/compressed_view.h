#pragma once

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace aoscore::gltf {

/// Two names of one scheme; the second adds a version of the attributes' coding and a filter for colours.
inline constexpr std::array<const char*, 2> kCompressionExtensions = {"EXT_meshopt_compression",
                                                                      "KHR_meshopt_compression"};

/// A buffer view whose bytes are coded by meshoptimizer, as the extensions above describe.
struct CompressedView {
    int buffer = 0;
    std::size_t offset = 0, bytes = 0;  ///< place of the stream within its buffer
    std::size_t stride = 0, count = 0;  ///< size and number of decoded elements
    std::string mode;                   ///< "ATTRIBUTES", "TRIANGLES", "INDICES"
    std::string filter;                 ///< "NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "COLOR"
};

/// The compressed buffer views of a document that check_structure() has passed, by their index.
std::map<int, CompressedView> compressed_views(const nlohmann::json& root);

/// Whether the stream is long enough for the elements that the view states; decodes nothing.
bool can_hold(const CompressedView& view);

/// Whether the stream is of a version that the library does not know.
bool is_unknown_version(const CompressedView& view, std::string_view stream);

/// Decodes a stream into `count * stride` bytes. Throws file_error at `where` for a stream that is broken, of
/// an unknown version, or too short for what it states (before anything is allocated).
std::string decode_view(const CompressedView& view, std::string_view stream, const std::string& where);

}  // namespace aoscore::gltf
