#include "core/error.h"
#include "image/image_file.h"
#include "image/png_with_alpha.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <memory>
#include <new>

namespace aoscore {
namespace {

struct PngJob {
    const Image<std::uint8_t>& bytes_of_rows;
    int width;
    int colour_type;
    std::span<const png_color> palette;  ///< the colours that indices stand for
    int bits;
    std::string bytes;
    std::string error;
};

PngJob& job_of(png_structp png) {
    return *static_cast<PngJob*>(png_get_io_ptr(png));
}

void append(png_structp png, png_bytep data, std::size_t size) {
    try {
        job_of(png).bytes.append(reinterpret_cast<const char*>(data), size);
    } catch (const std::bad_alloc&) {
        png_error(png, "out of memory");  // Exceptions must not pass through a C library.
    }
}

void flush(png_structp) {}

[[noreturn]] void fail(png_structp png, png_const_charp message) {
    static_cast<PngJob*>(png_get_error_ptr(png))->error = message;
    png_longjmp(png, 1);
}

void ignore(png_structp, png_const_charp) {}

/// Returns false when libpng fails. It leaves by longjmp, so nothing here may have a destructor.
bool write_png(png_structp png, png_infop info, PngJob& job) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_write_fn(png, &job, append, flush);
    png_set_IHDR(png, info, static_cast<png_uint_32>(job.width),
                 static_cast<png_uint_32>(job.bytes_of_rows.height), job.bits, job.colour_type,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (!job.palette.empty())
        png_set_PLTE(png, info, job.palette.data(), static_cast<int>(job.palette.size()));
    // Indices have no slope to predict; grays have.
    png_set_filter(png, PNG_FILTER_TYPE_BASE,
                   job.palette.empty() ? PNG_FILTER_SUB | PNG_FILTER_UP : PNG_FILTER_NONE);
    png_set_compression_level(png, 6);
    png_write_info(png, info);
    png_set_packing(png);  // Rows come with one byte a pixel, whatever the bits.
    for (int y = 0; y < job.bytes_of_rows.height; ++y) png_write_row(png, &job.bytes_of_rows.at(0, y));
    png_write_end(png, info);
    return true;
}

std::string encode(PngJob job) {
    if (job.bytes_of_rows.empty()) throw internal_error("a PNG without pixels");
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &job, fail, ignore);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
    const bool written = info != nullptr && write_png(png, info, job);
    png_destroy_write_struct(&png, &info);
    if (!written) throw internal_error("PNG: " + job.error);
    return std::move(job.bytes);
}

}  // namespace

std::string encode_png_indexed(const Image<std::uint8_t>& indices,
                               std::span<const std::uint32_t> palette_rgb) {
    if (palette_rgb.empty() || palette_rgb.size() > 256) {
        throw internal_error(fmt::format("a PNG palette of {} colours", palette_rgb.size()));
    }
    const auto largest = std::ranges::max_element(indices.pixels);
    if (largest != indices.pixels.end() && *largest >= palette_rgb.size()) {
        throw internal_error(
            fmt::format("index {} in a PNG palette of {} colours", *largest, palette_rgb.size()));
    }
    std::vector<png_color> palette;
    for (const std::uint32_t rgb : palette_rgb) {
        palette.push_back(
            {static_cast<png_byte>(rgb >> 16), static_cast<png_byte>(rgb >> 8), static_cast<png_byte>(rgb)});
    }
    int bits = 1;
    while ((std::size_t{1} << bits) < palette.size()) bits *= 2;
    return encode({indices, indices.width, PNG_COLOR_TYPE_PALETTE, palette, bits, {}, {}});
}

std::string encode_png_gray(const Image<std::uint8_t>& gray) {
    return encode({gray, gray.width, PNG_COLOR_TYPE_GRAY, {}, 8, {}, {}});
}

namespace {

/// Rows of neighbouring components, as libpng takes them.
template <std::size_t Components>
Image<std::uint8_t> rows_of(const Image<std::array<std::uint8_t, Components>>& colours) {
    Image<std::uint8_t> rows(static_cast<int>(Components) * colours.width, colours.height);
    auto next = rows.pixels.begin();
    for (const auto& colour : colours.pixels) next = std::ranges::copy(colour, next).out;
    return rows;
}

}  // namespace

std::string encode_png_rgb(const Image<std::array<std::uint8_t, 3>>& colours) {
    return encode({rows_of(colours), colours.width, PNG_COLOR_TYPE_RGB, {}, 8, {}, {}});
}

std::string encode_png_rgba(const Image<std::array<std::uint8_t, 4>>& colours) {
    return encode({rows_of(colours), colours.width, PNG_COLOR_TYPE_RGB_ALPHA, {}, 8, {}, {}});
}

}  // namespace aoscore
