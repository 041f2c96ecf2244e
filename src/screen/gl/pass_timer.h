#pragma once

#include "core/processor_watch.h"
#include "core/stopwatch.h"

#include <string>

namespace aoscore {

/// Whether this GL_RENDERER draws on the processor, so that its milliseconds say nothing of a GPU's.
bool is_software_renderer(const std::string& gl_renderer);

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
    /// Processor time of all threads of this process, between begin() and end(); on a GPU it is the driver's
    /// alone.
    double processor_ms() const { return processor_ms_; }
    /// The same up to now; by the wall clock, it waits for what was drawn.
    double processor_ms_so_far() const;

  private:
    unsigned query_ = 0;  ///< 0: the wall clock
    Stopwatch watch_;
    ProcessorWatch on_processor_;
    double wall_ms_ = 0, processor_ms_ = 0;
};

}  // namespace aoscore
