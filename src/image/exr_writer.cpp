#include "core/error.h"
#include "core/files.h"
#include "core/threads.h"
#include "image/image_file.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMatrixAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>
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

/// Rows of every channel from `y` on, `step` rows apart.
Imf::FrameBuffer rows_from(std::span<const ChannelView> channels, int y, int step) {
    Imf::FrameBuffer rows;
    for (const ChannelView& channel : channels) {
        // OpenEXR's one kind of slice serves reading too, hence no const; writing only reads.
        char* base = reinterpret_cast<char*>(const_cast<float*>(&channel.image->at(0, y)));
        const std::size_t row_bytes = sizeof(float) * static_cast<std::size_t>(channel.image->width);
        rows.insert(channel.name,
                    Imf::Slice(Imf::FLOAT, base, sizeof(float), static_cast<std::size_t>(step) * row_bytes));
    }
    return rows;
}

void set_packing(Imf::Header& header, bool packed) {
    header.compression() = packed ? Imf::ZIP_COMPRESSION : Imf::NO_COMPRESSION;
    header.zipCompressionLevel() = 1;  // Higher ones take half as long again, for a few hundredths less.
}

/// Whether packing takes a third off the file, by some of its rows. Visibility with noise hardly gets
/// smaller, while packing it takes twenty times as long as writing it, and unpacking it three times as long
/// as reading it.
bool is_worth_packing(std::span<const ChannelView> channels) {
    constexpr int kMostRows = 64;
    const int width = channels.front().image->width, height = channels.front().image->height;
    const int rows = std::min(height, kMostRows), step = height / rows;
    Imf::Header header(width, rows);
    set_packing(header, true);
    for (const ChannelView& channel : channels)
        header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
    Imf::StdOSStream packed;
    {
        Imf::OutputFile file(packed, header);
        file.setFrameBuffer(rows_from(channels, (height - 1 - (rows - 1) * step) / 2, step));
        file.writePixels(rows);
    }
    const std::size_t plain =
        sizeof(float) * channels.size() * static_cast<std::size_t>(width) * static_cast<std::size_t>(rows);
    return 3 * packed.str().size() <= 2 * plain;
}

}  // namespace

void write_exr(const std::filesystem::path& path, std::span<const ChannelView> channels,
               const std::map<std::string, std::string>& attributes) {
    require_writable(channels, path.string());
    if (Imf::globalThreadCount() != thread_count()) Imf::setGlobalThreadCount(thread_count());
    const int width = channels.front().image->width, height = channels.front().image->height;
    Imf::Header header(width, height);
    set_packing(header, is_worth_packing(channels));
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
    for (const ChannelView& channel : channels)
        header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));

    write_atomically(path, [&](const std::filesystem::path& temporary) {
        try {
            Imf::OutputFile file(temporary.c_str(), header);
            file.setFrameBuffer(rows_from(channels, 0, 1));
            file.writePixels(height);
        } catch (const std::exception& e) {
            throw file_error(std::string("cannot be written: ") + e.what(), path.string());
        }
    });
}

}  // namespace aoscore
