#pragma once

#include "image/image_file.h"
#include "page/pictures/first_look.h"
#include "page/pictures/quantised_image.h"
#include "results/results.h"

#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace aoscore {

/// A PNG as a data URI. Empty when there is no such picture.
struct Picture {
    std::string uri;
    int width = 0, height = 0;
    explicit operator bool() const { return !uri.empty(); }
};

/// The number of steps of the truth's standard error, which is itself no more precise than they are.
inline constexpr int kErrorLevels = 64;

struct ViewPictures {
    QuantisedImage truth;
    QuantisedImage standard_error;  ///< the truth's, 0 where it has none; NaN where nothing is compared
    bool has_standard_error = false;
    /// Metres; NaN where nothing is compared; without data where `depth_block` has them, or where no G-buffer
    /// was stored.
    QuantisedImage depth;
    std::string depth_block;  ///< the name of the live block that holds depth as it is; may be empty
    double depth_high_m = 0;  ///< 99 % of the valid pixels are nearer
    /// Of the ranking's occlusion, what has each cause ("outside", …), and what one depth layer could show of
    /// it
    /// ("one_layer"); empty where they were not traced, and where the page would become too large.
    std::map<std::string, QuantisedImage> occlusion;
    Picture truth_thumbnail;
    std::map<std::string, Picture> signals;  ///< the truth's signals beside visibility, by id
    Picture irradiance;                      ///< empty where nothing is lit by an environment
    double irradiance_white = 0;             ///< irradiance over pi that lit pictures show at full brightness
};

struct CellPictures {
    QuantisedImage output;
    QuantisedImage raw;  ///< the image before the filter; empty without one, and in large pages
    Picture output_thumbnail, raw_thumbnail;
    std::map<std::string, Picture> signals;          ///< signals beside visibility, by id
    std::map<std::string, Picture> signal_errors;    ///< where the truth's error is known
    std::map<std::string, Picture> lit, lit_errors;  ///< by the light mode
};

struct Pictures {
    std::map<std::string, ViewPictures> views;  ///< by ViewRecord::key
    std::map<std::string, CellPictures> cells;  ///< by CellRecord::id; failed cells have none
    std::vector<FirstLook> looks;               ///< one for each view, in their order
};

/// Receives the G-buffer of a view from its file, whose path is the last argument. Returns the name of the
/// block that holds its depth as it is; empty where there is none.
using GBufferUse = std::function<std::string(const ViewRecord& view, const ImageFile& gbuffer,
                                             const std::filesystem::path& path)>;

/// Reads the EXR files of the results, each once, and encodes every picture of the page, on all threads.
/// Small pages have 65535 levels of visibility, raw outputs and occlusion by cause; large ones have 255
/// levels, and the others only where `everything` is asked for. Throws file_error where a file or channel is
/// missing, differs in size, or lies outside the folder. G-buffers are shown to `use`, view by view, before
/// they are dropped.
Pictures make_pictures(const Results& results, const std::filesystem::path& folder, bool everything = false,
                       const GBufferUse& use = {});

}  // namespace aoscore
