#include "core/error.h"
#include "core/files.h"
#include "core/threads.h"
#include "image/image_file.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMatrixAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace aoscore {
namespace {

// The standard attributes that are matrices.
const std::set<std::string> kMatrixAttributes = {"worldToCamera", "worldToNDC"};

Imath::M44f matrix_of(const std::string& text, const std::string& where) {
    Imath::M44f matrix;
    std::istringstream in(text);
    for (int i = 0; i < 16; ++i) {
        if (!(in >> matrix[i / 4][i % 4]))
            throw internal_error("attribute is not 16 numbers: " + text, where);
    }
    return matrix;
}

void require_writable(std::span<const ChannelView> channels, const std::string& where) {
    if (channels.empty()) throw internal_error("an image without channels", where);
    std::set<std::string> names;
    for (const ChannelView& channel : channels) {
        if (!names.insert(channel.name).second) throw internal_error("two channels " + channel.name, where);
        if (channel.image->empty() || !channel.image->same_size(*channels.front().image)) {
            throw internal_error("channel " + channel.name + " is empty or of another size", where);
        }
    }
}

}  // namespace

void write_exr(const std::filesystem::path& path, std::span<const ChannelView> channels,
               const std::map<std::string, std::string>& attributes) {
    require_writable(channels, path.string());
    const int width = channels.front().image->width, height = channels.front().image->height;
    Imf::Header header(width, height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const auto& [name, value] : attributes) {
        if (header.find(name.c_str()) != header.end()) {
            throw internal_error("attribute " + name + " is the format's own", path.string());
        }
        if (kMatrixAttributes.contains(name)) {
            header.insert(name, Imf::M44fAttribute(matrix_of(value, path.string() + ": " + name)));
        } else {
            header.insert(name, Imf::StringAttribute(value));
        }
    }
    Imf::FrameBuffer pixels;
    for (const ChannelView& channel : channels) {
        header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
        // OpenEXR's one kind of slice serves reading too, hence no const; writing only reads.
        char* base = reinterpret_cast<char*>(const_cast<float*>(channel.image->pixels.data()));
        pixels.insert(channel.name, Imf::Slice(Imf::FLOAT, base, sizeof(float),
                                               sizeof(float) * static_cast<std::size_t>(width)));
    }

    if (Imf::globalThreadCount() != thread_count()) Imf::setGlobalThreadCount(thread_count());
    write_atomically(path, [&](const std::filesystem::path& temporary) {
        try {
            Imf::OutputFile file(temporary.c_str(), header);
            file.setFrameBuffer(pixels);
            file.writePixels(height);
        } catch (const std::exception& e) {
            throw file_error(std::string("cannot be written: ") + e.what(), path.string());
        }
    });
}

}  // namespace aoscore
