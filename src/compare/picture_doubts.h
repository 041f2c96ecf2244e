#pragma once

#include "image/visibility_file.h"

#include <string>
#include <vector>

namespace aoscore {

/// Reasons to doubt that a test image was read as its program meant it, a sentence each, with the option that
/// would read it otherwise: values outside of 0 to 1; a picture that follows the truth better turned over,
/// mirrored, inverted, or with the other coding; one that hardly follows it at all. `reading` is how `test`
/// was read; `turned_in_whole` says that both hold the whole frame, so that turning the test over means what
/// it means for the file. The images have one size, and the pixels of `valid` count.
std::vector<std::string> picture_doubts(const VisibilityFile& truth, const VisibilityFile& test,
                                        const Mask& valid, const VisibilityReading& reading,
                                        bool turned_in_whole);

}  // namespace aoscore
