#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace aoscore {

/// The spatial filters of FLIP at 67.02 pixels per degree, row by row: a pushed row is filtered across at
/// once, and down when enough rows are there, so that only the last rows are kept. Pontus Andersson, Jim
/// Nilsson, Tomas Akenine-Möller, Magnus Oskarsson, Kalle Åström, Mark Fairchild, "FLIP: A Difference
/// Evaluator for Alternating Images", 2020, sections 4.1.1 and 4.2.1.
class FlipFilter {
  public:
    /// The number of pixels read on each side of a pixel.
    static constexpr int kMargin_px = 9;
    static constexpr std::size_t kRows = 2 * kMargin_px + 1;

    /// The responses in a row: its own values, the values as the eye smooths them at that distance, and the
    /// first (edge) and second (point) derivatives in x and y.
    enum Response : std::size_t { kSelf, kSeen, kEdgeX, kEdgeY, kPointX, kPointY, kResponses };

    /// Makes a filter for rows of `width` pixels.
    explicit FlipFilter(std::size_t width);

    /// Pushes the next row from above, with the margin on both sides: width + 2 * kMargin_px values.
    void push(std::span<const double> row);
    /// Computes the responses in the row that was pushed kMargin_px rows before the last; kRows must have
    /// been pushed.
    void respond();
    std::span<double> operator[](Response response) {
        return std::span(responses_).subspan(response * width_, width_);
    }
    std::span<const double> operator[](Response response) const {
        return std::span(responses_).subspan(response * width_, width_);
    }

  private:
    /// The values kept of a pushed row.
    enum Kept : std::size_t { kRow, kContrast, kSmooth, kEdge, kPoint, kKept };

    double* kept(Kept what, std::size_t row) { return &kept_[(what * kRows + row % kRows) * width_]; }
    std::array<const double*, kRows> rows_of(Kept what);

    std::size_t width_, pushed_ = 0;
    std::vector<double> kept_, responses_;
};

}  // namespace aoscore
