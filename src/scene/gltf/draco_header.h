#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace aoscore::gltf {

/// The number of faces that the header of a Draco stream states, for which the decoder would allocate before
/// it reads any. Throws file_error at `where` for a stream that is no triangle mesh of Draco's bitstream 2.x,
/// and for more faces than any stream of that length could hold (Draco Bitstream Specification 2.2, Google
/// 2017, sections 3 to 7).
std::size_t stated_draco_faces(std::string_view stream, const std::string& where);

}  // namespace aoscore::gltf
