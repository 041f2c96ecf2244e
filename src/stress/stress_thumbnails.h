#pragma once

#include "core/image.h"

#include <filesystem>
#include <string>
#include <vector>

namespace aoscore {

/// No picture of a stress test is kept larger than this, pixels a side.
inline constexpr int kStressThumbnail_px = 64;

/// The picture at most kStressThumbnail_px wide and high, each pixel the mean of those it covers and NaN
/// where one of them is not finite, in steps of 1/`steps` so that files stay small.
ImageF stress_thumbnail(const ImageF& image, int steps);

/// Small pictures of one setting, for one file.
class StressThumbnails {
  public:
    /// <id>.Y and <id>.D of the same size; empty pictures are left out.
    void add(const std::string& id, const ImageF& picture, const ImageF& difference);
    bool empty() const { return channels_.empty(); }
    /// An EXR of all of them, of which there must be one; throws file_error when it cannot be written.
    void write(const std::filesystem::path& path) const;

  private:
    std::vector<std::pair<std::string, ImageF>> channels_;
};

}  // namespace aoscore
