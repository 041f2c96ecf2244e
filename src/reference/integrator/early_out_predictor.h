#pragma once

#include <cstddef>

namespace aoscore {

/// Predicts from earlier rays whether it pays to try the largest triangles first. It never changes a result.
class EarlyOutPredictor {
  public:
    bool worth_it() const {
        return kLeastPart * static_cast<double>(asked_) <= static_cast<double>(blocked_);
    }
    void learn(std::size_t asked, std::size_t blocked) {
        asked_ = asked_ / 2 + asked;  // what lies far back counts less
        blocked_ = blocked_ / 2 + blocked;
    }

  private:
    /// LargeTriangles take half the time of the whole scene, and rays that pass them lie apart from each
    /// other, so that they take three times as long as in full packets.
    static constexpr double kLeastPart = 0.8;
    std::size_t asked_ = 0, blocked_ = 0;
};

}  // namespace aoscore
