#pragma once

#include <memory>

namespace aoscore {

/// A shared library that is loaded when somebody asks for it, so that the program also runs where it is
/// absent.
class LoadedLibrary {
  public:
    /// Throws internal_error where it cannot be loaded; `package` is Debian's, which has it.
    LoadedLibrary(const char* name, const char* package);

    /// The library's function of this name. Throws internal_error where it has none.
    template <class Function>
    Function function(const char* name) const {
        return reinterpret_cast<Function>(symbol(name));
    }

  private:
    void* symbol(const char* name) const;

    const char* name_;
    void* handle_;  // for as long as the process lives: Mesa's threads outlive its contexts
};

}  // namespace aoscore
