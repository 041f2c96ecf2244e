#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// Goes before the id of a measure of light where it stands among others: "light.rmse.cone".
inline constexpr std::string_view kLightPrefix = "light.";

/// A way to light a surface by what a method knows: visibility, bent normal and cone (Vermeer,
/// Stochastic-Depth Ambient Occlusion, 2020, section 7.1; whether a cone's light is a mean over the cone, and
/// whether visibility multiplies it, is not said there).
struct LightMode {
    std::string_view id;
    std::string_view label;
    std::string_view meaning;  ///< one sentence
    bool bent = false;         ///< about the bent normal instead of the surface's
    bool cone = false;         ///< the mean over the cone instead of the hemisphere
    bool alone = false;        ///< the cone's own solid angle in place of visibility

    /// Its linear red, green and blue in the files of lit pictures: "bent_normal.R", ….
    std::array<std::string, 3> channels() const;
    // The ids of its errors among the measures of light, of luminance.
    std::string error() const;           ///< root mean squared: "rmse.bent_normal"
    std::string relative_error() const;  ///< the same over the mean of the truth: "relative_rmse.bent_normal"
    std::string bias() const;            ///< mean error over the mean of the truth: "bias.bent_normal"
    std::string gain() const;  ///< what it takes off the error of the mode before: "gain.bent_normal"
    /// All of them that there are: before the plainest mode there is none to gain on.
    std::vector<std::string> measures() const;
};

/// The one table of them, the plainest first.
std::span<const LightMode> light_modes();

}  // namespace aoscore
