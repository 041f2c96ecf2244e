#pragma once

#include "image/image_file.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>

#include <filesystem>
#include <string>
#include <vector>

namespace aoscore::testing {

/// A part of an EXR as other programs write it: its pixels begin at `x`, `y` of the display window.
struct ExrPart {
    std::string name;
    std::vector<ChannelView> channels;
    int x = 0, y = 0;
};

/// Writes scan-line parts of 32-bit float; one part alone may be without a name.
inline void write_parts(const std::filesystem::path& path, const std::vector<ExrPart>& parts, int frame_width,
                        int frame_height) {
    std::vector<Imf::Header> headers;
    for (const ExrPart& part : parts) {
        const ImageF& image = *part.channels.front().image;
        headers.emplace_back(
            Imath::Box2i({0, 0}, {frame_width - 1, frame_height - 1}),
            Imath::Box2i({part.x, part.y}, {part.x + image.width - 1, part.y + image.height - 1}));
        if (!part.name.empty()) headers.back().setName(part.name);
        headers.back().setType(Imf::SCANLINEIMAGE);
        for (const ChannelView& channel : part.channels)
            headers.back().channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
    }
    Imf::MultiPartOutputFile file(path.c_str(), headers.data(), static_cast<int>(headers.size()));
    for (std::size_t i = 0; i < parts.size(); ++i) {
        Imf::FrameBuffer pixels;
        for (const ChannelView& channel : parts[i].channels) {
            // OpenEXR's one kind of slice serves reading too, hence no const.
            auto* values = const_cast<float*>(channel.image->pixels.data());
            pixels.insert(channel.name,
                          Imf::Slice::Make(Imf::FLOAT, values, headers[i].dataWindow(), sizeof(float),
                                           sizeof(float) * static_cast<std::size_t>(channel.image->width)));
        }
        Imf::OutputPart part(file, static_cast<int>(i));
        part.setFrameBuffer(pixels);
        part.writePixels(parts[i].channels.front().image->height);
    }
}

}  // namespace aoscore::testing
