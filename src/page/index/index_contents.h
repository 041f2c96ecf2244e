#pragma once

#include "results/results.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// A view of a scene in one size and at one radius, whichever results hold it.
struct IndexedView {
    std::string scene, view;
    int width = 0, height = 0;
    double radius_m = 0;
    std::string picture;  ///< a small one of its truth, a data URI; empty where none was kept
};

/// A method with its preset, setting and filter.
struct IndexedContestant {
    std::string name;  ///< in words: "GTAO, default"
    std::string role = kMethodRole;
};

/// How a cell is lit by the environment of its results.
struct IndexedLight {
    double relative_error = 0;  ///< the least over its light modes
    std::string mode;           ///< that mode, in words
    std::string environment;    ///< "sky", or the name of a picture
};

/// A cell of some results: one contestant on one view.
struct IndexedCell {
    std::size_t view = 0, contestant = 0;  ///< their places in IndexContents
    std::optional<double> error;           ///< the ranking's metric; empty where it failed or has none
    std::optional<Interval> interval;      ///< of the error, by the blocks of its picture
    std::optional<double> bias, ms, fetches;
    std::optional<IndexedLight> light;  ///< empty where nothing was lit
    std::string rank;     ///< on its view among the contestants of its results; empty without one
    std::string failure;  ///< why it failed; else empty
    std::string link;     ///< to the cell on its results' page, from the index's folder; empty without a page
    std::string made;     ///< when, UTC
    std::string results;  ///< the folder of its results, from the index's folder
};

struct UnreadableResults {
    std::string path, reason;
};

/// What an index shows of any number of results.
struct IndexContents {
    std::vector<IndexedView> views;
    std::vector<IndexedContestant> contestants;
    std::vector<IndexedCell> cells;  ///< one of each contestant on each view: the latest, with the light of
                                     ///< an earlier one where it was not lit
    std::vector<UnreadableResults> unreadable;
    std::size_t read = 0;  ///< results that were read
    /// How many cells of which results, by their folder, were left out for later ones of the same contestant
    /// on the same view.
    std::map<std::string, std::size_t> replaced;
};

/// Gathers results one by one; they can be let go of afterwards.
class IndexBuilder {
  public:
    /// `page_folder` is where the index will lie, from which links lead.
    explicit IndexBuilder(const std::filesystem::path& page_folder)
        : page_folder_(std::filesystem::absolute(page_folder)) {}

    /// Adds results, which lie in `folder`, ranked as on their page. Throws file_error where a picture that
    /// they name cannot be read, and adds nothing then.
    void add(const Results& results, const std::filesystem::path& folder);
    void add_unreadable(const std::filesystem::path& path, const std::string& reason);

    const IndexContents& contents() const { return contents_; }

  private:
    std::size_t place_of(const ViewRecord& view, const std::string& picture);
    std::size_t place_of(const CellRecord& cell);
    void add_cell(IndexedCell cell);

    std::filesystem::path page_folder_;
    IndexContents contents_;
    std::map<std::string, std::size_t> views_, contestants_;
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> cells_;  ///< by view and contestant
};

}  // namespace aoscore
