#include "image/image_formats.h"

#include "core/error.h"
#include "core/processes/program_path.h"

#include <dlfcn.h>

namespace aoscore {
namespace {

const ImageFormats& loaded_formats() {
    const std::string path = beside_program("aoscore-formats.so").string();
    void* library = dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);
    void* function = library != nullptr ? dlsym(library, kImageFormatsFunction) : nullptr;
    if (function == nullptr) throw internal_error(std::string("cannot be loaded: ") + dlerror(), path);
    return *reinterpret_cast<ImageFormatsFunction>(function)();
}

}  // namespace

const ImageFormats& image_formats() {
    static const ImageFormats& formats = loaded_formats();
    return formats;
}

}  // namespace aoscore
