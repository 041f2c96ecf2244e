#pragma once

#include "reference/truth.h"

#include <algorithm>
#include <cmath>

namespace aoscore {

/// The part of the radius over which XeGTAO's falloff fades.
inline constexpr double kXegtaoFade = 0.615;

/// g(t): how much a hit at distance `t` (>= 0, infinity for a miss) darkens, in [0,1].
inline double darkening(const TruthQuery& query, double t) {
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

}  // namespace aoscore
