#pragma once

#include <cstddef>
#include <string>

namespace aoscore {

/// The memory that loading one scene may allocate. A small file can describe far more than it holds
/// (accessors without data, compressed images, thousands of primitives over one buffer), so everything of a
/// size that the file chooses is taken from here before it is allocated. That bounds the time as well.
class MemoryBudget {
  public:
    /// Throws file_error at `where` when the file as a whole asks for too much.
    void take(std::size_t bytes, const std::string& where);

  private:
    std::size_t left_ = std::size_t{1} << 30;
};

}  // namespace aoscore
