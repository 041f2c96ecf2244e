#include "screen/gl/egl_context.h"

#include "core/error.h"
#include "screen/gl/llvmpipe.h"
#include "screen/gl/loaded_library.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace aoscore {
namespace {

/// The functions of EGL 1.4 and of EXT_platform_device, EXT_device_enumeration and EXT_device_query.
struct Egl {
    LoadedLibrary library{"libEGL.so.1", "libegl1"};
    decltype(&eglGetProcAddress) address =
        library.function<decltype(&eglGetProcAddress)>("eglGetProcAddress");
    decltype(&eglInitialize) initialize = library.function<decltype(&eglInitialize)>("eglInitialize");
    decltype(&eglQueryString) display_string = library.function<decltype(&eglQueryString)>("eglQueryString");
    decltype(&eglBindAPI) bind = library.function<decltype(&eglBindAPI)>("eglBindAPI");
    decltype(&eglCreateContext) create = library.function<decltype(&eglCreateContext)>("eglCreateContext");
    decltype(&eglDestroyContext) destroy =
        library.function<decltype(&eglDestroyContext)>("eglDestroyContext");
    decltype(&eglMakeCurrent) make_current = library.function<decltype(&eglMakeCurrent)>("eglMakeCurrent");
    decltype(&eglGetCurrentContext) current =
        library.function<decltype(&eglGetCurrentContext)>("eglGetCurrentContext");
    PFNEGLQUERYDEVICESEXTPROC query_devices = extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    PFNEGLQUERYDEVICESTRINGEXTPROC device_string =
        extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    PFNEGLGETPLATFORMDISPLAYEXTPROC platform_display =
        extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");

  private:
    template <class Function>
    Function extension(const char* name) const {
        const auto found = reinterpret_cast<Function>(address(name));
        if (found == nullptr)
            throw internal_error(fmt::format("has no {}: it cannot list devices", name), "EGL");
        return found;
    }
};

const Egl& egl() {
    static const Egl loaded;
    return loaded;
}

std::vector<EGLDeviceEXT> devices() {
    std::array<EGLDeviceEXT, 64> found{};
    EGLint count = 0;
    if (egl().query_devices(found.size(), found.data(), &count) == EGL_FALSE)
        throw internal_error("lists no devices", "EGL");
    // In parentheses: braces would make a list of two devices of the two pointers.
    return std::vector<EGLDeviceEXT>(found.begin(), found.begin() + count);
}

std::string device_name(EGLDeviceEXT device) {
    const char* extensions = egl().device_string(device, EGL_EXTENSIONS);
    if (extensions == nullptr) return "unnamed";
    if (std::string_view(extensions).find("EGL_MESA_device_software") != std::string_view::npos)
        return "software";
    const char* path = egl().device_string(device, EGL_DRM_DEVICE_FILE_EXT);
    return path == nullptr ? "unnamed" : path;
}

EGLDeviceEXT device_called(const std::string& wanted) {
    const std::vector<EGLDeviceEXT> all = devices();
    const std::vector<std::string> names = egl_devices();
    if (all.empty()) throw internal_error("lists no device", "EGL");
    if (wanted.empty()) return all.front();
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (wanted == std::to_string(i)) return all[i];
        if (names[i].find(wanted) != std::string::npos) found.push_back(i);
    }
    if (found.size() == 1) return all[found.front()];
    throw usage_error(fmt::format("EGL has {} device called {} (list devices prints them: {})",
                                  found.empty() ? "no" : "more than one", wanted, fmt::join(names, ", ")));
}

}  // namespace

std::vector<std::string> egl_devices() {
    std::vector<std::string> names;
    for (const EGLDeviceEXT device : devices()) names.push_back(device_name(device));
    return names;
}

struct EglContext::State {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
    bool tells_loss = false;

    /// Creates a context that says when it is lost, where the driver has such, else another.
    void create() {
        const char* extensions = egl().display_string(display, EGL_EXTENSIONS);
        tells_loss =
            extensions != nullptr &&
            std::string_view(extensions).find("EGL_EXT_create_context_robustness") != std::string_view::npos;
        if (tells_loss)
            context =
                created({EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_EXT, EGL_LOSE_CONTEXT_ON_RESET_EXT});
        if (context != EGL_NO_CONTEXT) return;
        tells_loss = false;
        context = created({});
    }

    EGLContext created(const std::vector<EGLint>& further) const {
        std::vector<EGLint> attributes = {
            EGL_CONTEXT_MAJOR_VERSION,       3,
            EGL_CONTEXT_MINOR_VERSION,       3,
            EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT};
        attributes.insert(attributes.end(), further.begin(), further.end());
        attributes.push_back(EGL_NONE);
        return egl().create(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
    }

    // The display stays initialised: it is the device's, and another context may use it.
    ~State() {
        if (context == EGL_NO_CONTEXT) return;
        if (egl().current() == context)
            egl().make_current(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        egl().destroy(display, context);
    }
};

EglContext::EglContext(const std::string& device) : state_(std::make_unique<State>()) {
    limit_rasteriser_threads();
    require_addresses();
    const EGLDeviceEXT chosen = device_called(device);
    const std::string name = device_name(chosen);
    state_->display = egl().platform_display(EGL_PLATFORM_DEVICE_EXT, chosen, nullptr);
    if (state_->display == EGL_NO_DISPLAY || egl().initialize(state_->display, nullptr, nullptr) == EGL_FALSE)
        throw internal_error(fmt::format("the device {} cannot be opened", name), "EGL");
    if (egl().bind(EGL_OPENGL_API) == EGL_TRUE) state_->create();
    if (state_->context == EGL_NO_CONTEXT)
        throw internal_error(fmt::format("the device {} gives no context of OpenGL 3.3 core", name), "EGL");
    make_current();
}

EglContext::~EglContext() = default;

void EglContext::make_current() {
    if (egl().current() == state_->context) return;
    if (egl().make_current(state_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, state_->context) == EGL_FALSE)
        throw internal_error("the OpenGL context cannot be made current without a surface", "EGL");
}

bool EglContext::tells_loss() const {
    return state_->tells_loss;
}

GlContext::Function EglContext::function(const char* name) const {
    return egl().address(name);
}

}  // namespace aoscore
