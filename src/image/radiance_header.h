#pragma once

#include <filesystem>

namespace aoscore {

/// By how much a Radiance picture's values were multiplied since they were visibility: the product of the
/// lines EXPOSURE= of its header, which programs append to; 1 without one, and where a line is no number
/// above 0.
float radiance_exposure(const std::filesystem::path& path);

}  // namespace aoscore
