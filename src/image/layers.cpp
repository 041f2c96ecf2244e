#include "image/layers.h"

#include "core/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

namespace aoscore {
namespace {

// Components that make a picture together; the first stands for all.
constexpr std::array<std::array<std::string_view, 3>, 4> kPictures{{
    {"r", "g", "b"},
    {"red", "green", "blue"},
    {"x", "y", "z"},
    {"y", "ry", "by"},
}};

bool is_chroma(const std::string& name) {
    const std::string component = lower_case(ChannelName(name).component);
    return component == "ry" || component == "by";
}

}  // namespace

std::vector<Layer> layers_of(const ImageFile& file) {
    std::vector<ChannelName> names;
    for (const std::string& name : file.channel_names) names.emplace_back(name);
    std::vector<bool> taken(names.size(), false);
    std::vector<Layer> layers;
    const auto take = [&](std::size_t c, Layer& layer) {
        taken[c] = true;
        layer.channels.push_back(c);
    };
    const auto sibling = [&](const ChannelName& of,
                             std::string_view component) -> std::optional<std::size_t> {
        for (std::size_t c = 0; c < names.size(); ++c) {
            if (!taken[c] && names[c].layer == of.layer && lower_case(names[c].component) == component)
                return c;
        }
        return std::nullopt;
    };
    for (const auto& picture : kPictures) {
        for (std::size_t c = 0; c < names.size(); ++c) {
            if (taken[c] || lower_case(names[c].component) != picture[0]) continue;
            Layer layer{{}, meaning_of(names[c])};
            take(c, layer);
            for (std::size_t i = 1; i < picture.size(); ++i) {
                if (const auto other = sibling(names[c], picture[i])) take(*other, layer);
            }
            layers.push_back(layer);
        }
    }
    for (std::size_t c = 0; c < names.size(); ++c) {
        if (!taken[c]) layers.push_back({{c}, meaning_of(names[c])});
    }
    std::ranges::sort(layers, {}, [](const Layer& layer) { return layer.channels.front(); });
    return layers;
}

bool is_grey(const Layer& layer, const ImageFile& file) {
    // One and a half levels of 8 bits; for floats, four times the rounding of half precision near 1.
    const float most = file.integers ? 1.5F / 255 : 2e-3F;
    const ImageF& first = file.channels[layer.channels.front()];
    return std::ranges::all_of(layer.channels, [&](std::size_t c) {
        const bool chroma = is_chroma(file.channel_names[c]);
        return std::ranges::equal(first.pixels, file.channels[c].pixels, [&](float a, float b) {
            return std::abs(chroma ? b : a - b) <= most || a == b || (std::isnan(a) && std::isnan(b));
        });
    });
}

}  // namespace aoscore
