#include "image/plain_exr.h"

#include "core/threads.h"
#include "image/exr_header.h"
#include "image/image_limits.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfMatrixAttribute.h>
#include <ImfStringAttribute.h>
#include <ImfTestFile.h>
#include <ImfThreading.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace aoscore {
namespace {

// The order in which OpenImageIO lists the channels of a layer, but for A beside Y: such files are not plain.
constexpr std::string_view kComponents = "RGBAXYZ";

struct PlainName {
    std::string layer;  ///< with its dot; empty for the layer without a name
    std::size_t component;

    auto operator<=>(const PlainName&) const = default;
};

/// Empty for a name that promises another kind of channel.
std::optional<PlainName> plain_name(std::string_view name) {
    if (name.empty()) return std::nullopt;
    const std::string_view layer = name.substr(0, name.size() - 1);
    const std::size_t component = kComponents.find(name.back());
    const bool is_layer = layer.empty() || (layer.size() > 1 && layer.ends_with('.'));
    if (!is_layer || component == std::string_view::npos) return std::nullopt;
    return PlainName{std::string(layer), component};
}

/// The names of the channels as they are listed; empty where one of them is of another kind.
std::vector<std::string> plain_channels(const Imf::Header& header) {
    std::vector<std::pair<PlainName, std::string>> named;
    for (auto c = header.channels().begin(); c != header.channels().end(); ++c) {
        const Imf::Channel& channel = c.channel();
        const std::optional<PlainName> name = plain_name(c.name());
        if (!name || channel.type == Imf::UINT || channel.xSampling != 1 || channel.ySampling != 1) return {};
        const bool alpha = kComponents[name->component] == 'A';
        if (alpha && header.channels().findChannel(name->layer + 'Y') != nullptr) return {};
        named.emplace_back(*name, c.name());
    }
    std::ranges::sort(named);
    std::vector<std::string> names;
    for (const auto& [order, name] : named) names.push_back(name);
    return names;
}

/// Whether the header's kind of file is a plain one, and its claims fit into the file's bytes.
bool is_plain(const Imf::Header& header, std::size_t channels, const std::filesystem::path& path) {
    const Imath::Box2i& window = header.dataWindow();
    const auto has = [&](const char* name) { return header.find(name) != header.end(); };
    if (window != header.displayWindow() || has("multiView") || has("Orientation")) return false;
    const double width = 1.0 + window.max.x - window.min.x, height = 1.0 + window.max.y - window.min.y;
    const double most = static_cast<double>(std::filesystem::file_size(path)) * kMostValuesAByte;
    return width * height * static_cast<double>(channels) <= most;
}

void read_channels_of(Imf::InputFile& input, ImageFile& file) {
    const Imath::Box2i& window = input.header().dataWindow();
    Imf::FrameBuffer pixels;
    for (std::size_t c = 0; c < file.channel_names.size(); ++c) {
        file.channels.emplace_back(file.width, file.height);
        file.covered.push_back({0, 0, file.width, file.height});
        pixels.insert(file.channel_names[c],
                      Imf::Slice::Make(Imf::FLOAT, file.channels[c].pixels.data(), window, sizeof(float),
                                       sizeof(float) * static_cast<std::size_t>(file.width)));
    }
    input.setFrameBuffer(pixels);
    input.readPixels(window.min.y, window.max.y);
}

std::map<std::string, std::string> attributes_of_header(const Imf::Header& header) {
    std::map<std::string, std::string> attributes;
    for (auto a = header.begin(); a != header.end(); ++a) {
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&a.attribute()))
            attributes[a.name()] = text->value();
        if (const auto* matrix = dynamic_cast<const Imf::M44fAttribute*>(&a.attribute()))
            attributes[a.name()] =
                fmt::format("{}", fmt::join(std::span(matrix->value().getValue(), 16), " "));
    }
    return attributes;
}

}  // namespace

std::optional<ImageFile> read_plain_exr(const std::filesystem::path& path) {
    bool tiled = false, deep = false, several_parts = false;
    const bool exr = Imf::isOpenExrFile(path.c_str(), tiled, deep, several_parts);
    if (!exr || tiled || deep || several_parts) return std::nullopt;
    require_plausible_exr_header(path);
    if (Imf::globalThreadCount() != thread_count()) Imf::setGlobalThreadCount(thread_count());
    try {
        Imf::InputFile input(path.c_str());
        const Imf::Header& header = input.header();
        ImageFile file;
        file.channel_names = plain_channels(header);
        if (file.channel_names.empty() || !is_plain(header, file.channel_names.size(), path) ||
            !input.isComplete())
            return std::nullopt;
        file.width = header.dataWindow().max.x - header.dataWindow().min.x + 1;
        file.height = header.dataWindow().max.y - header.dataWindow().min.y + 1;
        require_allocatable(file.width, file.height, static_cast<int>(file.channel_names.size()),
                            path.string());
        read_channels_of(input, file);
        file.attributes = attributes_of_header(header);
        return file;
    } catch (const std::exception&) {
        return std::nullopt;  // OpenImageIO reports what is wrong with the file.
    }
}

}  // namespace aoscore
