#pragma once

#include "reference/truth.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace aoscore {

/// Owen-scrambled Sobol points, made once and shared by all pixels: a pixel takes one of a few sets and
/// shifts it digitally (exclusive or) by random bits of its own. A digital shift of an Owen-scrambled net is
/// one again, and since a shift alone already makes every point uniform, two pixels are uncorrelated even
/// where they share a set.
class PointSets {
  public:
    /// Sets of `points` points each.
    PointSets(PointKind kind, int points);

    struct Coordinates {
        const std::uint32_t* u;  ///< fractions of 2^32
        const std::uint32_t* v;
    };
    Coordinates set(std::uint64_t bits) const {
        const std::size_t begin = number(bits) * points_;
        return {&u_[begin], &v_[begin]};
    }

    static constexpr std::size_t kSets = 16;
    /// Which of them set(bits) is.
    static std::size_t number(std::uint64_t bits) { return bits % kSets; }
    PointKind kind() const { return kind_; }

  private:
    PointKind kind_;
    std::size_t points_;
    std::vector<std::uint32_t> u_, v_;
};

}  // namespace aoscore
