#include "image/subsampled_exr.h"

#include "core/error.h"
#include "image/image_frame.h"
#include "image/image_limits.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <ImfTestFile.h>

#include <algorithm>
#include <list>

namespace aoscore {
namespace {

struct Sampled {
    std::string name;
    int x_step, y_step;
    ImageF values;
};

/// A picture of the data window's size: each value of a channel stands for x_step times y_step pixels.
ImageF at_full_resolution(const Sampled& channel, const Imath::Box2i& window) {
    ImageF full(window.max.x - window.min.x + 1, window.max.y - window.min.y + 1);
    for (int y = 0; y < full.height; ++y) {
        for (int x = 0; x < full.width; ++x)
            full.at(x, y) = channel.values.at(x / channel.x_step, y / channel.y_step);
    }
    return full;
}

std::list<Sampled> read_channels(Imf::InputFile& input, const Imath::Box2i& window) {
    const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
    std::list<Sampled> channels;  // a list, whose elements never move
    Imf::FrameBuffer pixels;
    const Imf::ChannelList& stored = input.header().channels();
    for (auto channel = stored.begin(); channel != stored.end(); ++channel) {
        const int x_step = channel.channel().xSampling, y_step = channel.channel().ySampling;
        channels.push_back({channel.name(), x_step, y_step,
                            ImageF((width + x_step - 1) / x_step, (height + y_step - 1) / y_step)});
        ImageF& values = channels.back().values;
        pixels.insert(
            channel.name(),
            Imf::Slice::Make(Imf::FLOAT, values.pixels.data(), window, sizeof(float),
                             sizeof(float) * static_cast<std::size_t>(values.width), x_step, y_step));
    }
    input.setFrameBuffer(pixels);
    input.readPixels(window.min.y, window.max.y);
    return channels;
}

}  // namespace

bool is_subsampled_exr(const std::filesystem::path& path) {
    try {
        if (!Imf::isOpenExrFile(path.c_str())) return false;
        const Imf::InputFile input(path.c_str());
        const Imf::ChannelList& channels = input.header().channels();
        for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
            if (channel.channel().xSampling > 1 || channel.channel().ySampling > 1) return true;
        }
        return false;
    } catch (const std::exception&) {
        return false;  // The reader reports what is wrong with the file.
    }
}

ImageFile read_subsampled_exr(const std::filesystem::path& path) {
    const std::string where = path.string();
    try {
        Imf::InputFile input(path.c_str());
        // Checked before anything is allocated for the header's claims.
        if (!input.isComplete()) throw file_error("is not complete", where, "a whole image file");
        const Imath::Box2i window = input.header().dataWindow(), frame = input.header().displayWindow();
        ImageFile file;
        file.width = frame.max.x - frame.min.x + 1;
        file.height = frame.max.y - frame.min.y + 1;
        int count = 0;
        for (auto c = input.header().channels().begin(); c != input.header().channels().end(); ++c) ++count;
        require_allocatable(file.width, file.height, count, where);
        require_allocatable(window.max.x - window.min.x + 1, window.max.y - window.min.y + 1, count, where);
        const int x = window.min.x - frame.min.x, y = window.min.y - frame.min.y;
        for (const Sampled& channel : read_channels(input, window)) {
            const ImageF full = at_full_resolution(channel, window);
            file.covered.push_back(within_frame({x, y, full.width, full.height}, file.width, file.height));
            file.channel_names.push_back(channel.name);
            file.channels.push_back(placed(full, x, y, file.width, file.height));
        }
        for (auto a = input.header().begin(); a != input.header().end(); ++a) {
            if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&a.attribute()))
                file.attributes[a.name()] = text->value();
        }
        return file;
    } catch (const Error&) {
        throw;
    } catch (const std::exception& e) {
        throw file_error(std::string("cannot be read: ") + e.what(), where, "an image file");
    }
}

}  // namespace aoscore
