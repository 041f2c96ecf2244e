#pragma once

#include "reference/truth.h"

#include <algorithm>
#include <cmath>

namespace aoscore {

/// The part of the radius over which XeGTAO's falloff fades.
inline constexpr double kXegtaoFade = 0.615;

/// Occlusions are whole multiples of this: sums of as many as a pixel may have are exact in double precision,
/// whatever the order and however many rounds they come in. No grey level in float32 shows it.
inline constexpr double kOcclusionStep = 0x1p-16;

/// The multiple of `step`, a power of two, next to `x`; |x| < 2^50 step.
inline double in_steps(double x, double step) {
    const double large = 0x1.8p52 * step;  // whose last place is one step
    return (x + large) - large;
}

/// g(t) before rounding.
inline double exact_occlusion(const TruthQuery& query, double t) {
    if (!(t <= query.radius_m) || std::isinf(t)) return 0;
    switch (query.falloff) {
        case Falloff::binary:
            return 1;
        case Falloff::quadratic:
            return 1 - (t / query.radius_m) * (t / query.radius_m);
        case Falloff::xegtao:
            return std::isinf(query.radius_m)
                       ? 1.0
                       : std::min((query.radius_m - t) / (kXegtaoFade * query.radius_m), 1.0);
        case Falloff::alchemy: {
            const double longer = std::max(query.u_m, t);
            return query.u_m * t / (longer * longer);
        }
    }
    return 0;
}

/// g(t): how much a hit at distance `t` (>= 0, infinity for a miss) darkens, in [0,1], rounded to
/// kOcclusionStep.
inline double occlusion_at(const TruthQuery& query, double t) {
    return in_steps(exact_occlusion(query, t), kOcclusionStep);
}

}  // namespace aoscore
