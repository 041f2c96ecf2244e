#pragma once

#include <ctime>

namespace aoscore {

/// Measures the processor time of all threads of this process since its construction: what others do on the
/// machine hardly counts.
class ProcessorWatch {
  public:
    double milliseconds() const { return 1000 * static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC; }

  private:
    std::clock_t start_ = std::clock();
};

}  // namespace aoscore
