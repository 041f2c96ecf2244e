#pragma once

#include <filesystem>
#include <vector>

namespace aoscore::gltf {

/// The files of buffers and images that a glTF file names beside itself, as paths that begin as its own does;
/// whether they are there is not asked. None for a file of another format, or one that cannot be read: what
/// loads it says why.
std::vector<std::filesystem::path> side_files(const std::filesystem::path& file);

}  // namespace aoscore::gltf
