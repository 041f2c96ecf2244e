#include "image/visibility_channel.h"

#include "core/error.h"
#include "core/known_names.h"
#include "core/text.h"
#include "image/layers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

namespace aoscore {
namespace {

constexpr const char* kWhatQualifies =
    "one layer named AO, AmbientOcclusion, SSAO, occlusion or the like; else a single picture in grey and no "
    "other; or the channel's name, by --channel";

const std::string& name_of(const Layer& layer, const ImageFile& file) {
    return file.channel_names[layer.channels.front()];
}

std::string names_of(const std::vector<const Layer*>& layers, const ImageFile& file) {
    std::vector<std::string> names;
    for (const Layer* layer : layers) names.push_back(name_of(*layer, file));
    return fmt::format("{}", fmt::join(names, ", "));
}

std::string all_channels(const ImageFile& file) {
    const std::string names = fmt::format("{}", fmt::join(file.channel_names, ", "));
    return file.left_out.empty() ? names
                                 : fmt::format("{} (left out: {})", names, fmt::join(file.left_out, ", "));
}

bool same_values(const ImageF& a, const ImageF& b) {
    return std::ranges::equal(a.pixels, b.pixels,
                              [](float x, float y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

/// Whether Y repeats a channel of geometry: files of geometry store one there because viewers show Y.
bool is_copy_of_geometry(const Layer& layer, const std::vector<Layer>& all, const ImageFile& file) {
    return std::ranges::any_of(all, [&](const Layer& other) {
        return other.meaning == ChannelMeaning::geometry &&
               std::ranges::any_of(other.channels, [&](std::size_t c) {
                   return same_values(file.channels[layer.channels.front()], file.channels[c]);
               });
    });
}

std::vector<const Layer*> with_meaning(const std::vector<Layer>& layers, ChannelMeaning meaning) {
    std::vector<const Layer*> found;
    for (const Layer& layer : layers) {
        if (layer.meaning == meaning) found.push_back(&layer);
    }
    return found;
}

/// The only picture whose name says nothing, when it is in grey.
VisibilityChannel only_picture(const std::vector<Layer>& layers, const ImageFile& file,
                               const std::string& where) {
    std::vector<const Layer*> pictures = with_meaning(layers, ChannelMeaning::unknown);
    std::erase_if(pictures, [&](const Layer* layer) { return is_copy_of_geometry(*layer, layers, file); });
    const bool has_shading = !with_meaning(layers, ChannelMeaning::shading).empty();
    if (pictures.size() > 1) {
        throw file_error("more than one channel may be visibility: " + names_of(pictures, file), where,
                         kWhatQualifies);
    }
    if (pictures.empty() || has_shading || !is_grey(*pictures.front(), file)) {
        throw file_error(fmt::format("no channel of visibility among {}{}", all_channels(file),
                                     has_shading ? ", which are passes of a lit picture" : ""),
                         where, kWhatQualifies);
    }
    return {pictures.front()->channels.front(),
            pictures.front()->channels.size() == 1 ? "the only picture" : "the only picture, in grey",
            file.left_out.empty() ? "" : fmt::format("not looked at: {}", fmt::join(file.left_out, ", "))};
}

VisibilityChannel found(const ImageFile& file, const std::string& where) {
    if (const auto y = file.index("Y"); y && file.channel("V0.Y") != nullptr)
        return {*y, "the truth at its first radius", ""};
    if (const auto y = file.index("Y"); y && file.channel("raw.Y") != nullptr)
        return {*y, "the method's output, behind its filter", ""};
    const std::vector<Layer> layers = layers_of(file);
    const std::vector<const Layer*> occlusion = with_meaning(layers, ChannelMeaning::occlusion);
    if (occlusion.size() > 1) {
        throw file_error("more than one channel is named as ambient occlusion: " + names_of(occlusion, file),
                         where, "the one to take, by --channel");
    }
    if (occlusion.empty()) return only_picture(layers, file, where);
    const Layer& layer = *occlusion.front();
    return {layer.channels.front(), "named as ambient occlusion",
            is_grey(layer, file) ? "" : "the layer is not in grey, so that its other channels say otherwise"};
}

/// The layers with a channel whose name, or whose layer's name, is the one asked for or ends in it behind a
/// dot.
std::vector<const Layer*> answering(const std::vector<Layer>& layers, const ImageFile& file,
                                    const std::string& asked) {
    const auto ends = [&](const std::string& name) {
        return ("." + lower_case(name)).ends_with("." + lower_case(asked));
    };
    std::vector<const Layer*> answers;
    for (const Layer& layer : layers) {
        if (ends(ChannelName(name_of(layer, file)).layer)) answers.push_back(&layer);
    }
    return answers;
}

std::size_t named(const ImageFile& file, const std::string& asked, const std::string& where) {
    if (const auto exact = file.index(asked)) return *exact;
    std::vector<std::size_t> answers;
    for (std::size_t c = 0; c < file.channel_names.size(); ++c) {
        if (("." + lower_case(file.channel_names[c])).ends_with("." + lower_case(asked)))
            answers.push_back(c);
    }
    const std::vector<Layer> layers = layers_of(file);
    if (answers.empty()) {
        for (const Layer* layer : answering(layers, file, asked)) answers.push_back(layer->channels.front());
    }
    if (answers.size() == 1) return answers.front();
    if (answers.empty()) {
        throw file_error(unknown_name_text("has no channel", asked, file.channel_names), where,
                         all_channels(file));
    }
    std::vector<std::string> names;
    for (const std::size_t c : answers) names.push_back(file.channel_names[c]);
    throw file_error(fmt::format("more than one channel is {}", asked), where,
                     fmt::format("{}", fmt::join(names, ", ")));
}

bool is_mask_layer(const std::string& layer) {
    static const std::set<std::string, std::less<>> kNames = {"mask", "matte", "valid", "coverage"};
    const std::string lower = lower_case(layer);
    return kNames.contains(lower.substr(lower.rfind('.') == std::string::npos ? 0 : lower.rfind('.') + 1));
}

}  // namespace

VisibilityChannel find_visibility(const ImageFile& file, const std::string& asked, const std::string& where) {
    if (asked.empty()) return found(file, where);
    return {named(file, asked, where), "asked for", ""};
}

std::size_t find_mask(const ImageFile& file, const std::string& asked, const std::string& where) {
    if (!asked.empty()) return named(file, asked, where);
    std::vector<const Layer*> masks, grey;
    const std::vector<Layer> layers = layers_of(file);
    for (const Layer& layer : layers) {
        if (is_mask_layer(ChannelName(name_of(layer, file)).layer)) masks.push_back(&layer);
        if (layer.meaning != ChannelMeaning::geometry && is_grey(layer, file)) grey.push_back(&layer);
    }
    for (const auto& choice : {masks, grey}) {
        if (choice.size() == 1) return choice.front()->channels.front();
    }
    throw file_error("no channel, or more than one, is a mask among " + all_channels(file), where,
                     "mask.Y, or a single picture in grey; or the channel's name, by --mask-channel");
}

}  // namespace aoscore
