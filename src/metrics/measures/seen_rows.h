#pragma once

#include "core/image.h"
#include "metrics/measures/flip_filter.h"
#include "metrics/measures/image_area.h"
#include "metrics/measures/seen_image.h"

#include <optional>
#include <span>
#include <vector>

namespace aoscore {

/// The pixels of an area that count, with FLIP's filters applied to them where some do not.
class ValidRows {
  public:
    /// Both must outlive it.
    ValidRows(const Mask& valid, const ImageArea& area);

    const ImageArea& area() const { return area_; }
    const Mask& mask() const { return valid_; }
    /// Whether all pixels count in the area and its margin.
    bool all_valid() const { return !filter_; }
    /// The filters' responses to 1 where a pixel counts, in row `y` of the image; null where all pixels count
    /// in the area and its margin. Rows must be asked for from the area's top on, each at least once.
    const FlipFilter* responses(int y);

  private:
    bool has_invalid() const;
    void push(int y);

    const Mask& valid_;
    const ImageArea& area_;
    std::optional<FlipFilter> filter_;
    int next_ = 0;  ///< the row whose responses come next
};

/// FLIP's features of an image within an area, row by row.
class SeenRows {
  public:
    virtual ~SeenRows() = default;
    /// The next row from the area's top, from the area's left; it is valid until the next call.
    virtual SeenRow next() = 0;
};

/// Rows that are filtered when they are asked for.
class FilteredRows final : public SeenRows {
  public:
    /// Both must outlive it. Several images can share the rows of one mask when they advance together.
    FilteredRows(const ImageF& image, ValidRows& valid);
    SeenRow next() override;

  private:
    void push(int y);
    /// Removes the invalid pixels from the responses: a mean is over the valid ones alone.
    void without_invalid(const FlipFilter& valid);

    const ImageF& image_;
    ValidRows& valid_;
    FlipFilter filter_;
    std::vector<double> lightness_, edges_, points_;
    int next_;
};

/// Rows of an image that was filtered before.
class StoredRows final : public SeenRows {
  public:
    /// Both must outlive it.
    StoredRows(const SeenImage& seen, const ImageArea& area) : seen_(seen), area_(area), next_(area.top) {}
    SeenRow next() override;

  private:
    const SeenImage& seen_;
    const ImageArea& area_;
    int next_;
};

}  // namespace aoscore
