#include "core/error.h"
#include "results/image_file.h"

#include <png.h>

#include <csetjmp>
#include <new>

namespace aoscore {
namespace {

struct PngJob {
    const Image<std::uint8_t>& pixels;
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

/// Nothing here may have a destructor: libpng leaves by longjmp when it fails. False then.
bool write_png(png_structp png, png_infop info, PngJob& job) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_write_fn(png, &job, append, flush);
    png_set_IHDR(png, info, static_cast<png_uint_32>(job.pixels.width),
                 static_cast<png_uint_32>(job.pixels.height), 8, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB | PNG_FILTER_UP);
    png_set_compression_level(png, 6);
    png_write_info(png, info);
    for (int y = 0; y < job.pixels.height; ++y) png_write_row(png, &job.pixels.at(0, y));
    png_write_end(png, info);
    return true;
}

}  // namespace

std::string encode_png_gray(const Image<std::uint8_t>& gray) {
    if (gray.empty()) throw internal_error("a PNG without pixels");
    PngJob job{gray, {}, {}};
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &job, fail, ignore);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
    const bool written = info != nullptr && write_png(png, info, job);
    png_destroy_write_struct(&png, &info);
    if (!written) throw internal_error("PNG: " + job.error);
    return std::move(job.bytes);
}

}  // namespace aoscore
