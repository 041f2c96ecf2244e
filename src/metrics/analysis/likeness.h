#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace aoscore {

/// The correlation of a test image with the truth, which ignores brightness and contrast.
struct Likeness {
    double correlation = 0;  ///< Pearson's, from -1 to 1
    double rmse = 0;

    /// The share of the truth's variance that no multiple of the test plus a constant explains; all of it
    /// where the correlation is negative.
    double unexplained() const { return correlation < 0 ? 1 : 1 - correlation * correlation; }
};

/// Sums that give the likeness of two images, row by row. The result depends on the order in which rows are
/// added in its last digits.
class LikenessSums {
  public:
    /// Adds the pixels of a row that count and are finite in both images. The spans have one size.
    void add(std::span<const float> truth, std::span<const float> test, std::span<const std::uint8_t> valid);
    void add(const LikenessSums& other);
    /// Empty where fewer than two pixels were added, or where either image is constant.
    std::optional<Likeness> likeness() const;

  private:
    double count_ = 0, truth_ = 0, test_ = 0, truth_squared_ = 0, test_squared_ = 0, product_ = 0;
};

}  // namespace aoscore
