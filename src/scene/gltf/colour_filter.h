#pragma once

#include <cstddef>
#include <string>

namespace aoscore::gltf {

/// Undoes the filter COLOR in place: RGBA from luma, two chroma components and an alpha whose highest bit
/// tells the precision (KHR_meshopt_compression, Khronos Group, appendix B, filter 4). `component_bytes` is 1
/// or 2; `bytes` holds whole elements of four components.
void decode_colours(std::string& bytes, std::size_t component_bytes);

}  // namespace aoscore::gltf
