#pragma once

#include "plan/plan.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// A cell that a claim asks about, and where: what is planned, and what the results are searched for.
struct ClaimCell {
    std::string view;  ///< name in ClaimList::views
    CellPlan plan;
    std::optional<double> x;  ///< the varied value where it is a number, else the view's pixels
    std::string label;        ///< what was varied: "samples 8"; else the method and preset
};

/// One measurable part of a claim: an expression of quantities of cells that must lie in a range.
struct ClaimCheck {
    enum class Kind {
        order,             ///< each cell's quantity is less than the next one's
        monotone,          ///< each cell's quantity is at most the next one's plus `tolerance`
        ratio,             ///< first over second
        difference,        ///< first minus second
        ratio_difference,  ///< first over second minus third over fourth
        slope,             ///< of log quantity over log x, least squares
        value,             ///< of every cell
        spread,            ///< (largest - smallest) / mean
        gain,              ///< (third - fourth) / (first - second): what a later step gains of an earlier one
    };
    Kind kind = Kind::value;
    std::string quantity;
    std::vector<ClaimCell> cells;
    std::optional<double> low, high;  ///< the range; order and monotone have none
    double tolerance = 0;
    std::string about;  ///< what it shows, in words
};

/// What decides a claim where constants that its source does not print have these values.
struct ClaimSetting {
    std::string about;  ///< the values, in words; empty where nothing is left open
    std::vector<ClaimCheck> checks;
};

/// One statement of a source and what decides it here.
struct Claim {
    std::string id;      ///< "H01"
    std::string source;  ///< what says it, as source_reference() has it
    std::string place;   ///< where in the source
    std::string text;    ///< in our own words
    /// More than one where the source leaves constants open, over their plausible range. A claim is decided
    /// only where it is at all of them alike.
    std::vector<ClaimSetting> settings;
    std::string open;    ///< which constants are left open, and where their range is taken from
    std::string cannot;  ///< why nothing here can tell; set where there are no settings
    std::string own;     ///< what the source's own printed numbers say of it; empty where they agree
    std::string note;    ///< how our measurement differs from what the source looked at
};

/// The claims of one source, or of several about one subject: reports/claims/<id>.json.
struct ClaimList {
    std::string id;
    std::map<std::string, ViewPlan> views;  ///< without cells
    std::vector<Claim> claims;
};

/// All lists, by id. Throws file_error for one that is not understood, or an id of a claim that stands twice.
std::vector<ClaimList> load_claims();
/// The lists of a folder.
std::vector<ClaimList> load_claims(const std::filesystem::path& folder);

/// Those of the claims whose ids are named, or whose list's id is: "H01", "field"; all when `ids` is empty.
/// Throws usage_error for an unknown id.
std::vector<ClaimList> chosen_claims(std::vector<ClaimList> lists, const std::vector<std::string>& ids);

/// Makes every view `factor` times as wide and high, for a quicker or a finer answer.
void scale_views(std::vector<ClaimList>& lists, double factor);

/// Adds every cell that the claims ask about, each once.
void plan_claims(ExperimentPlan& plan, const std::vector<ClaimList>& lists);

}  // namespace aoscore
