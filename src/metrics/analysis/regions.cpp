#include "metrics/analysis/regions.h"

#include "core/threads.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>

namespace aoscore {
namespace {

/// A region with its sums while it grows.
struct Growing {
    ErrorRegion region;
    int first_x = 0, first_y = 0;  ///< its first pixel in reading order
    int right = 0, bottom = 0;
    double error_sum = 0;
    std::vector<double> occlusion;  ///< by cause

    /// Takes the larger error; of equal ones, that which is read first.
    void take_worst(double error, int x, int y) {
        const double size = std::abs(error), worst = std::abs(region.worst_error);
        const bool earlier =
            y < region.worst_y || (y == region.worst_y && x < region.worst_x) || region.area_px == 0;
        if (size < worst || (size == worst && !earlier)) return;
        region.worst_error = error;
        region.worst_x = x;
        region.worst_y = y;
    }

    void add(int x, int y, double error) {
        take_worst(error, x, y);
        error_sum += error;
        ++region.area_px;
    }

    void add(const Growing& other) {
        take_worst(other.region.worst_error, other.region.worst_x, other.region.worst_y);
        if (other.first_y < first_y || (other.first_y == first_y && other.first_x < first_x)) {
            first_x = other.first_x;
            first_y = other.first_y;
        }
        region.left = std::min(region.left, other.region.left);
        region.top = std::min(region.top, other.region.top);
        right = std::max(right, other.right);
        bottom = std::max(bottom, other.bottom);
        error_sum += other.error_sum;
        region.area_px += other.region.area_px;
        for (std::size_t c = 0; c < occlusion.size(); ++c) occlusion[c] += other.occlusion[c];
    }

    /// Whether it is listed before another one.
    bool is_worse_than(const Growing& other) const {
        const double badness = std::abs(error_sum), of_other = std::abs(other.error_sum);
        if (badness != of_other) return badness > of_other;
        return first_y < other.first_y || (first_y == other.first_y && first_x < other.first_x);
    }

    ErrorRegion finished(const std::string& kind, const std::vector<PixelFacts::Cause>& causes) const {
        ErrorRegion result = region;
        result.kind = kind;
        result.width = right - region.left + 1;
        result.height = bottom - region.top + 1;
        result.mean_error = error_sum / static_cast<double>(region.area_px);
        const auto most = std::ranges::max_element(occlusion);
        if (most != occlusion.end() && *most > 0)
            result.cause = causes[static_cast<std::size_t>(most - occlusion.begin())].name;
        return result;
    }
};

/// Neighbouring pixels of a row that belong to the mask, and the place of their region.
struct Run {
    int begin, end;
    std::size_t place;
};

/// Finds the worst pieces of a mask row by row: runs that touch a run of the row above join its region, and a
/// region that no run of a row has joined is finished. Only the regions of the last row and the worst of
/// those that are finished are kept.
class RegionFinder {
  public:
    RegionFinder(const Mask& mask, const MetricInput& input, const std::vector<PixelFacts::Cause>& causes)
        : mask_(mask), input_(input), causes_(causes) {}

    /// The pieces, worst first, as many as are listed.
    std::vector<Growing> worst() {
        for (int y = 0; y < mask_.height; ++y) {
            find_runs(y);
            join_touching();
            finish_others(y);
            std::swap(above_, runs_);
        }
        runs_.clear();
        finish_others(mask_.height);
        return std::move(worst_);
    }

  private:
    /// A region's place, which may have been joined to another one.
    struct Place {
        Growing growing;
        std::size_t joined;  ///< the place that it was joined to, or its own
    };

    std::size_t root_of(std::size_t place) {
        while (places_[place].joined != place)
            place = places_[place].joined = places_[places_[place].joined].joined;
        return place;
    }

    void find_runs(int y) {
        runs_.clear();
        const std::uint8_t* row = &mask_.at(0, y);
        const auto next = [&](int x, int value) {
            const void* found = std::memchr(row + x, value, static_cast<std::size_t>(mask_.width - x));
            return found == nullptr ? mask_.width
                                    : static_cast<int>(static_cast<const std::uint8_t*>(found) - row);
        };
        for (int begin = next(0, 1); begin < mask_.width;) {
            const int end = next(begin, 0);
            runs_.push_back({begin, end, new_place(begin, end, y)});
            begin = next(end, 1);
        }
    }

    std::size_t new_place(int begin, int end, int y) {
        std::size_t place = places_.size();
        if (free_.empty()) {
            places_.emplace_back();
        } else {
            place = free_.back();
            free_.pop_back();
        }
        places_[place] = {growing_from(begin, end, y), place};
        return place;
    }

    Growing growing_from(int begin, int end, int y) const {
        Growing growing;
        growing.first_x = growing.region.left = begin;
        growing.first_y = growing.region.top = growing.bottom = y;
        growing.right = end - 1;
        growing.occlusion.assign(causes_.size(), 0);
        for (int x = begin; x < end; ++x) {
            const std::size_t i = mask_.index(x, y);
            growing.add(x, y, double{input_.test.pixels[i]} - double{input_.truth.pixels[i]});
            for (std::size_t c = 0; c < causes_.size(); ++c)
                growing.occlusion[c] += double{causes_[c].occlusion->pixels[i]};
        }
        return growing;
    }

    /// Joins the regions of runs that touch, also at a corner.
    void join_touching() {
        auto above = above_.begin();
        for (const Run& run : runs_) {
            while (above != above_.end() && above->end < run.begin) ++above;
            for (auto touching = above; touching != above_.end() && touching->begin <= run.end; ++touching)
                join(root_of(touching->place), root_of(run.place));
        }
    }

    void join(std::size_t place, std::size_t other) {
        if (place == other) return;
        places_[place].growing.add(places_[other].growing);
        places_[other].joined = place;
        joined_.push_back(other);
    }

    /// Finishes the regions of the row above that do not reach row `y`.
    void finish_others(int y) {
        for (const Run& run : above_) {
            const std::size_t place = root_of(run.place);
            if (places_[place].growing.bottom >= y || places_[place].growing.region.area_px == 0) continue;
            list(places_[place].growing);
            places_[place].growing.region.area_px = 0;  // A region may have several runs.
            free_.push_back(place);
        }
        for (Run& run : runs_) run.place = root_of(run.place);
        free_.insert(free_.end(), joined_.begin(), joined_.end());
        joined_.clear();
    }

    void list(const Growing& region) {
        if (worst_.size() == kListedRegions && !region.is_worse_than(worst_.back())) return;
        const auto after =
            std::ranges::find_if(worst_, [&](const Growing& listed) { return region.is_worse_than(listed); });
        worst_.insert(after, region);
        if (worst_.size() > kListedRegions) worst_.pop_back();
    }

    const Mask& mask_;
    const MetricInput& input_;
    const std::vector<PixelFacts::Cause>& causes_;
    std::vector<Run> above_, runs_;
    std::vector<Place> places_;
    std::vector<std::size_t> free_, joined_;
    std::vector<Growing> worst_;
};

}  // namespace

std::vector<ErrorRegion> worst_regions(const OcclusionMasks& masks, const MetricInput& input,
                                       const std::vector<PixelFacts::Cause>& causes) {
    struct Kind {
        const char* name;
        const Mask& mask;
    };
    const Kind kinds[] = {{"missing", masks.missing}, {"false", masks.false_occlusion}};
    std::vector<std::vector<ErrorRegion>> of_kinds(std::size(kinds));
    parallel_for(std::size(kinds), [&](std::size_t k) {
        for (const Growing& region : RegionFinder(kinds[k].mask, input, causes).worst())
            of_kinds[k].push_back(region.finished(kinds[k].name, causes));
    });
    std::ranges::move(of_kinds[1], std::back_inserter(of_kinds[0]));
    return std::move(of_kinds[0]);
}

}  // namespace aoscore
