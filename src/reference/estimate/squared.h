#pragma once

namespace aoscore {

inline double squared(double x) {
    return x * x;
}

}  // namespace aoscore
