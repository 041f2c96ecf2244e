#include "formats/readers.h"
#include "image/image_limits.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace aoscore {
namespace {

glm::u8vec4 to_rgba(const std::uint8_t* pixel, int channels) {
    switch (channels) {
        case 1:
            return {pixel[0], pixel[0], pixel[0], 255};
        case 2:
            return {pixel[0], pixel[0], pixel[0], pixel[1]};
        case 3:
            return {pixel[0], pixel[1], pixel[2], 255};
        default:
            return {pixel[0], pixel[1], pixel[2], pixel[3]};
    }
}

}  // namespace

std::optional<Image<glm::u8vec4>> decode_picture(const char* format, std::string_view bytes,
                                                 MemoryBudget& budget, std::string& reason) {
    reason = "is broken";
    OIIO::Filesystem::IOMemReader memory(const_cast<char*>(bytes.data()), bytes.size());
    const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(format);
    OIIO::ImageSpec config, spec;
    config["oiio:UnassociatedAlpha"] = 1;
    if (!input || !input->set_ioproxy(&memory) || !input->open(format, spec, config)) {
        // The message may quote the file; it is fetched here so that nobody else reports it.
        static_cast<void>(input ? input->geterror() : OIIO::geterror());
        return std::nullopt;
    }
    if (!texture_fits(spec.width, spec.height, spec.nchannels, budget, reason)) return std::nullopt;
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    Image<glm::u8vec4> image(spec.width, spec.height);
    std::vector<std::uint8_t> samples(image.size() * channels);
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeUInt8, samples.data())) {
        static_cast<void>(input->geterror());
        return std::nullopt;
    }
    for (std::size_t i = 0; i < image.size(); ++i) {
        image.pixels[i] = to_rgba(&samples[i * channels], spec.nchannels);
    }
    return image;
}

}  // namespace aoscore
