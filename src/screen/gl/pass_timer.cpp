#include "screen/gl/pass_timer.h"

#include "screen/gl/gl.h"

namespace aoscore {

PassTimer::PassTimer(Clock clock) {
    if (clock == Clock::queries) gl::GenQueries(1, &query_);
}

PassTimer::~PassTimer() {
    if (query_ != 0) gl::DeleteQueries(1, &query_);
}

void PassTimer::begin() {
    if (query_ != 0) {
        gl::BeginQuery(GL_TIME_ELAPSED, query_);
    } else {
        watch_ = Stopwatch();
    }
    on_processor_ = ProcessorWatch();
}

void PassTimer::end() {
    if (query_ != 0) {
        gl::EndQuery(GL_TIME_ELAPSED);
    } else {
        gl::Finish();
        wall_ms_ = watch_.seconds() * 1e3;
    }
    processor_ms_ = on_processor_.milliseconds();
}

std::optional<double> PassTimer::processor_ms() const {
    return query_ == 0 ? std::optional(processor_ms_) : std::nullopt;
}

std::optional<double> PassTimer::processor_ms_so_far() const {
    if (query_ != 0) return std::nullopt;
    gl::Finish();
    return on_processor_.milliseconds();
}

double PassTimer::milliseconds() const {
    if (query_ == 0) return wall_ms_;
    GLuint64 ns = 0;
    gl::GetQueryObjectui64v(query_, GL_QUERY_RESULT, &ns);
    return static_cast<double>(ns) * 1e-6;
}

}  // namespace aoscore
