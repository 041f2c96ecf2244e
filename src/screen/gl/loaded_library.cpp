#include "screen/gl/loaded_library.h"

#include "core/error.h"

#include <dlfcn.h>
#include <fmt/format.h>

namespace aoscore {

LoadedLibrary::LoadedLibrary(const char* name, const char* package)
    : name_(name), handle_(dlopen(name, RTLD_NOW | RTLD_LOCAL)) {
    if (handle_ == nullptr)
        throw internal_error(fmt::format("cannot be loaded ({}); the package {} has it", dlerror(), package),
                             name);
}

void* LoadedLibrary::symbol(const char* name) const {
    void* found = dlsym(handle_, name);
    if (found == nullptr) throw internal_error(fmt::format("has no function {}", name), name_);
    return found;
}

}  // namespace aoscore
