#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace aoscore {

/// The spatial filters of FLIP at 67.02 pixels per degree, row by row: only the last rows that were pushed
/// are kept, and are filtered down and then across when the responses in the middle one are asked for. Pontus
/// Andersson, Jim Nilsson, Tomas Akenine-Möller, Magnus Oskarsson, Kalle Åström, Mark Fairchild, "FLIP: A
/// Difference Evaluator for Alternating Images", 2020, sections 4.1.1 and 4.2.1.
class FlipFilter {
  public:
    /// The number of pixels read on each side of a pixel.
    static constexpr int kMargin_px = 9;
    static constexpr std::size_t kRows = 2 * kMargin_px + 1;

    /// The responses in a row: the values as the eye smooths them at that distance, and the first (edge) and
    /// second (point) derivatives in x and y.
    enum Response : std::size_t { kSeen, kEdgeX, kEdgeY, kPointX, kPointY, kResponses };

    /// Makes a filter for rows of `width` pixels.
    explicit FlipFilter(std::size_t width);

    /// Gives the place of the next row from above, to be filled with its values and a margin on both sides:
    /// width + 2 * kMargin_px in all.
    std::span<double> push();
    /// Computes the responses in the row that was pushed kMargin_px rows before the last; kRows must have
    /// been pushed.
    void respond();
    std::span<double> operator[](Response response) {
        return std::span(responses_).subspan(response * width_, width_);
    }
    std::span<const double> operator[](Response response) const {
        return std::span(responses_).subspan(response * width_, width_);
    }
    /// The values of the row with the responses.
    std::span<const double> middle() const { return {row(pushed_ + kMargin_px) + kMargin_px, width_}; }

  private:
    /// A row filtered down, with its margins.
    enum Down : std::size_t { kContrast, kSmooth, kEdge, kPoint, kDowns };

    const double* row(std::size_t pushed) const { return &kept_[pushed % kRows * with_margins_]; }
    double* down(Down what) { return &down_[what * with_margins_]; }
    std::size_t width_, with_margins_, pushed_ = 0;
    std::vector<double> kept_, down_, responses_;
};

}  // namespace aoscore
