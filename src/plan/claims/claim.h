#pragma once

#include "plan/plan.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// A cell that a claim asks about, on its view: the plan gets it, and the results are searched for it.
struct ClaimCell {
    std::string view;  ///< its name in ClaimList::views
    CellPlan plan;
    std::optional<double> x;  ///< the varied value where it is a number, else the view's pixels
    std::string label;        ///< the varied value: "samples 8"; else method and preset
    /// The number of draws of random kernels and noise that it is measured with; its quantity is their mean,
    /// or that of the draw with the least.
    int draws = 1;
    bool best_draw = false;

    /// The cells to be measured: one for each draw.
    std::vector<CellPlan> drawn() const;
};

/// One measurable part of a claim: an expression of quantities of cells that must lie in a range.
struct ClaimCheck {
    enum class Kind {
        order,             ///< each cell's quantity is less than the next one's
        monotone,          ///< each cell's quantity is at most the next one's plus `tolerance`
        ratio,             ///< first over second
        difference,        ///< first minus second
        ratio_difference,  ///< first over second minus third over fourth
        slope,             ///< slope of log quantity over log x, by least squares
        value,             ///< the quantity of every cell
        spread,            ///< (largest - smallest) / mean
        gain,  ///< (third - fourth) / (first - second): the gain of a later step over an earlier one's
        /// The first's less the others' at the first's cost: between the two that cost less and more, by the
        /// logarithm of the cost; the dearest of them where all cost less, the cheapest where all cost more.
        at_equal_cost,
    };
    Kind kind = Kind::value;
    std::string quantity;
    std::string cost;  ///< at_equal_cost: the quantity that is equal
    std::vector<ClaimCell> cells;
    std::optional<double> low, high;  ///< the range; order and monotone have none
    double tolerance = 0;
    std::string about;  ///< the meaning, in words
};

/// The checks that decide a claim for given values of constants that its source does not print.
struct ClaimSetting {
    std::string about;  ///< the values, in words; empty where the source leaves none open
    std::vector<ClaimCheck> checks;
};

/// One statement of a source, and the checks that decide it here.
struct Claim {
    std::string id;      ///< "H01"
    std::string source;  ///< as source_reference() writes it
    std::string place;   ///< place in the source
    std::string text;    ///< in our own words
    /// Several where the source leaves constants open, over their plausible range. A claim is decided only
    /// where all settings agree.
    std::vector<ClaimSetting> settings;
    std::string open;    ///< the constants left open, and the source of their range
    std::string cannot;  ///< why nothing here can decide it; set without settings
    std::string own;     ///< how the source's printed numbers differ; empty where they agree
    std::string note;    ///< how our measurement differs from the source's
};

/// A part of the picture, from its top left corner, in parts of its width and height: 0 to 1.
struct ClaimRegion {
    double left = 0, top = 0, right = 1, bottom = 1;
};

/// The claims of one source, or of several sources about one subject: reports/claims/<id>.json.
struct ClaimList {
    std::string id;
    std::map<std::string, ViewPlan> views;  ///< they have no cells
    /// Of the views in which only a part of the picture counts, by their names.
    std::map<std::string, ClaimRegion> regions;
    std::vector<Claim> claims;
};

/// Loads all lists, by id. Throws file_error for a list that is not understood, and for a repeated id of a
/// claim.
std::vector<ClaimList> load_claims();
/// Loads the lists of a folder.
std::vector<ClaimList> load_claims(const std::filesystem::path& folder);

/// The claims whose id, or whose list's id, is named: "H01", "field"; all when `ids` is empty. Throws
/// usage_error for an unknown id.
std::vector<ClaimList> chosen_claims(std::vector<ClaimList> lists, const std::vector<std::string>& ids);

/// Makes every view `factor` times as wide and high, for a quicker or a finer answer.
void scale_views(std::vector<ClaimList>& lists, double factor);

/// Adds to the plan every cell that the claims ask about, each once.
void plan_claims(ExperimentPlan& plan, const std::vector<ClaimList>& lists);

}  // namespace aoscore
