#pragma once

#include "screen/gl/context.h"

#include <memory>
#include <string>
#include <vector>

namespace aoscore {

/// A context without a surface on a device of EGL: a GPU's driver, or Mesa's software renderer. Its source is
/// the only one that sees the library.
class EglContext final : public GlContext {
  public:
    /// Creates the context on the device of this index, or on the only one whose path or vendor has `device`
    /// in it; on the first where `device` is empty. Makes it current. Throws usage_error for a device that is
    /// not there, naming those that are; internal_error where it gives no context of OpenGL 3.3.
    explicit EglContext(const std::string& device);
    ~EglContext() override;

    void make_current() override;
    Function function(const char* name) const override;
    bool tells_loss() const override;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// What EGL's devices call themselves, in the order of their indices: the path of their driver, or
/// "software". Throws internal_error where EGL is not installed or lists no devices.
std::vector<std::string> egl_devices();

}  // namespace aoscore
