#include "image/channel_meaning.h"

#include "core/text.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <vector>

namespace aoscore {
namespace {

using Words = std::set<std::string, std::less<>>;

// Words that name a layer of ambient occlusion: names of the pass in renderers, and methods after which
// engines name their buffers.
const Words kOcclusion = {"ao",    "occlusion", "occ",    "obscurance", "ambocc", "ssao",
                          "hbao",  "gtao",      "rtao",   "vxao",       "hdao",   "assao",
                          "cacao", "sao",       "xegtao", "n8ao",       "vbao",   "mssao"};
// Some names write it as one word in lower case.
constexpr std::string_view kAmbientOcclusion = "ambientocclusion";

// Words that make it another kind of occlusion, or data about the occlusion.
const Words kNotAmbient = {"specular", "spec",     "reflection", "reflections", "refl", "bent",
                           "normal",   "variance", "error",      "samples",     "count"};

const Words kGeometry = {"z",
                         "depth",
                         "zdepth",
                         "mist",
                         "fog",
                         "disparity",
                         "normal",
                         "normals",
                         "n",
                         "ns",
                         "ng",
                         "p",
                         "pref",
                         "position",
                         "positions",
                         "albedo",
                         "basecolor",
                         "vector",
                         "velocity",
                         "motion",
                         "motionvector",
                         "uv",
                         "st",
                         "tangent",
                         "curvature",
                         "id",
                         "index",
                         "object",
                         "material",
                         "crypto",
                         "mask",
                         "cryptomatte",
                         "matte",
                         "alpha",
                         "coverage",
                         "variance",
                         "error",
                         "se",
                         "samplecount",
                         "roughness",
                         "relativevariance",
                         "metallic",
                         "metalness",
                         "bent",
                         "cone",
                         "cause",
                         "stencil"};
const Words kShading = {"diffuse",    "diff",       "specular",     "spec",        "glossy",    "shadow",
                        "shadows",    "light",      "lighting",     "gi",          "direct",    "indirect",
                        "emission",   "emissive",   "emit",         "reflection",  "sss",       "reflections",
                        "refraction", "subsurface", "transmission", "environment", "env",       "background",
                        "volume",     "sheen",      "coat",         "radiance",    "irradiance"};
// Words for the rendered picture. Within a part or a view layer that is named AO they mean the occlusion.
const Words kPicture = {"beauty", "combined", "color", "colour", "scenecolor", "clay"};

// Component names that are values of a layer; A is its alpha.
const Words kComponents = {"r", "g", "b",   "a",     "x",    "y",     "z",  "u",  "v",
                           "w", "l", "red", "green", "blue", "alpha", "ry", "by", "luminance"};

/// The words of a name, in lower case and without trailing digits. Separators divide words, and so does a
/// capital in mixed case ("SceneDepth", "AOPass").
std::vector<std::string> words_of(const std::string& name) {
    const auto is = [&](std::size_t i, int (*kind)(int)) {
        return i < name.size() && kind(static_cast<unsigned char>(name[i])) != 0;
    };
    std::vector<std::string> words(1);
    for (std::size_t i = 0; i < name.size(); ++i) {
        const bool begins =
            is(i, std::isupper) && ((i > 0 && is(i - 1, std::islower)) ||
                                    (i > 0 && is(i - 1, std::isupper) && is(i + 1, std::islower)));
        if (!is(i, std::isalnum) || begins) words.emplace_back();
        if (is(i, std::isalnum)) words.back() += lower_case(name.substr(i, 1));
    }
    for (std::string& word : words) {
        while (!word.empty() && std::isdigit(static_cast<unsigned char>(word.back())) != 0) word.pop_back();
    }
    std::erase(words, "");
    return words;
}

bool any_of(const std::vector<std::string>& words, const Words& known) {
    return std::ranges::any_of(words, [&](const std::string& word) { return known.contains(word); });
}

bool is_ambient_occlusion(const std::vector<std::string>& words) {
    std::string together;
    for (const std::string& word : words) together += word;
    const bool named = any_of(words, kOcclusion) || together.find(kAmbientOcclusion) != std::string::npos;
    return named && !any_of(words, kNotAmbient);
}

}  // namespace

ChannelName::ChannelName(const std::string& name) : layer(name) {
    const auto dot = name.rfind('.');
    const std::string last = dot == std::string::npos ? name : name.substr(dot + 1);
    if (!kComponents.contains(lower_case(last))) return;
    component = last;
    layer = dot == std::string::npos ? "" : name.substr(0, dot);
}

ChannelMeaning meaning_of(const ChannelName& name) {
    const std::string component = lower_case(name.component);
    if (component == "a" || component == "alpha") return ChannelMeaning::geometry;
    ChannelMeaning picture = ChannelMeaning::unknown;
    // The part behind the last dot says most: "AO.Depth" is the depth of a view layer that is named AO.
    for (std::size_t end = name.layer.size(); end > 0;) {
        const auto dot = name.layer.rfind('.', end - 1);
        const std::size_t begin = dot == std::string::npos ? 0 : dot + 1;
        const std::vector<std::string> words = words_of(name.layer.substr(begin, end - begin));
        if (is_ambient_occlusion(words)) return ChannelMeaning::occlusion;
        if (any_of(words, kGeometry)) return ChannelMeaning::geometry;
        if (any_of(words, kShading)) return ChannelMeaning::shading;
        if (any_of(words, kPicture)) picture = ChannelMeaning::shading;
        end = dot == std::string::npos ? 0 : dot;
    }
    // Z without a word beside it is depth, and u and v in lower case are coordinates of textures.
    if (component == "z" || (name.layer.empty() && (name.component == "u" || name.component == "v")))
        return ChannelMeaning::geometry;
    return picture;
}

}  // namespace aoscore
