#pragma once

#include <filesystem>

namespace aoscore {

/// The most 16-bit values that a byte of an EXR can stand for. Deflate packs at most 1032 bytes into one (RFC
/// 1951); DWA keeps 2 bytes of a block of 64 equal values before that.
constexpr double kMostValuesAByte = 1032 / 2, kMostValuesAByteOfDwa = 64.0 / 2 * 1032;

/// Throws file_error for an EXR whose attributes claim more bytes than the file has, or whose data window
/// claims more pixels than any compression could hold in it: OpenEXR would allocate them, or a table of their
/// lines, before it reads. Files of other formats, and other faults, are left to the readers.
void require_plausible_exr_header(const std::filesystem::path& path);

}  // namespace aoscore
