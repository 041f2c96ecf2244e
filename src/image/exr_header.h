#pragma once

#include <filesystem>

namespace aoscore {

/// The most values of 16 bits that a byte of an EXR can stand for. Deflate makes a byte of at most 1032 (RFC
/// 1951); DWA keeps 2 bytes of a block of 64 equal values before that.
constexpr double kMostValuesAByte = 1032 / 2, kMostValuesAByteOfDwa = 64.0 / 2 * 1032;

/// Throws file_error for an EXR of which an attribute claims more bytes than the file has, or the data window
/// more pixels than any compression could hold in it: OpenEXR would make room for them, or for a table of
/// their lines, and fill it before it reads. Files of other formats, and what else is wrong, are left to
/// those who read them.
void require_plausible_exr_header(const std::filesystem::path& path);

}  // namespace aoscore
