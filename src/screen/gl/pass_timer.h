#pragma once

#include "core/processor_watch.h"
#include "core/stopwatch.h"

#include <optional>

namespace aoscore {

/// Times what is drawn between begin() and end().
///
/// On a GPU by GL_TIME_ELAPSED (OpenGL 3.3): nothing waits between passes, which overlap as in a frame, and
/// milliseconds() reads the result when all are drawn. A software renderer's query tells when its commands
/// were taken, not drawn (1 ms where 210 ms pass), so that there end() waits until all is drawn, for the wall
/// clock.
class PassTimer {
  public:
    enum class Clock { queries, wall };
    /// The context must be current, and stay so.
    explicit PassTimer(Clock clock);
    PassTimer(const PassTimer&) = delete;
    PassTimer& operator=(const PassTimer&) = delete;
    ~PassTimer();

    void begin();
    void end();
    /// Waits for the result of a query.
    double milliseconds() const;
    /// Processor time of all threads of this process between begin() and end(), milliseconds; empty on a GPU,
    /// where it would be the driver's alone.
    std::optional<double> processor_ms() const;
    /// The same up to now, once what was drawn has ended.
    std::optional<double> processor_ms_so_far() const;

  private:
    unsigned query_ = 0;  ///< 0: the wall clock
    Stopwatch watch_;
    ProcessorWatch on_processor_;
    double wall_ms_ = 0, processor_ms_ = 0;
};

}  // namespace aoscore
