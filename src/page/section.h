#pragma once

#include "page/live/live_data.h"
#include "page/pictures/pictures.h"
#include "results/results.h"

#include <nlohmann/json.hpp>

#include <string_view>
#include <vector>

namespace aoscore {

/// The source of every section.
struct PageSource {
    const Results& results;
    const Pictures& pictures;
    const LiveData& live;
};

/// One section of the page: a row of the table in sections.cpp, a file that builds its model, and the
/// Mustache fragment reports/page/sections/<id>.html that shows it. The model holds texts, booleans, lists
/// and objects only. That of a folded section has its result in a sentence, "in_short".
struct Section {
    std::string_view id;
    std::string_view title;
    nlohmann::json (*build)(const PageSource&);
    /// The results that it shows: only views and cells whose images were stored; these, or all where no image
    /// was stored and no sweep or claim explains the cells; or all.
    enum class Of { pictured, ranked, all } of = Of::pictured;
    /// Whether it applies to the results; the page leaves it out otherwise.
    bool (*applies)(const Results&) = nullptr;
    bool folded = true;  ///< shows a line until a reader unfolds it; its contents are built then
};

/// All sections in the order of the page.
const std::vector<Section>& sections();

namespace section {
nlohmann::json verdict(const PageSource& source);
nlohmann::json ranking(const PageSource& source);
nlohmann::json advice(const PageSource& source);
nlohmann::json pictures(const PageSource& source);
nlohmann::json cost(const PageSource& source);
nlohmann::json failures(const PageSource& source);
nlohmann::json distributions(const PageSource& source);
nlohmann::json live(const PageSource& source);
nlohmann::json signals(const PageSource& source);
nlohmann::json light(const PageSource& source);
nlohmann::json published(const PageSource& source);
nlohmann::json sweeps(const PageSource& source);
nlohmann::json claims(const PageSource& source);
nlohmann::json measurement(const PageSource& source);
}  // namespace section

/// The part of the results whose images were stored.
Results pictured(const Results& results);

/// The cell of that id; null when there is none.
const CellRecord* find_cell(const Results& results, const std::string& id);
/// The view of that key. Throws file_error when there is none.
const ViewRecord& find_view(const Results& results, const std::string& key);
/// The view's truth of that id; null when there is none.
const TruthRecord* find_truth(const ViewRecord& view, const std::string& id);
/// The cost of a method without the G-buffer that all need: AO pass and filter, ms.
std::optional<double> cost_ms(const CellRecord& cell);
/// A truth in words: "binary, 0.5 m", "alchemy, u 0.128 m, infinite".
std::string truth_text(const TruthRecord& truth);

}  // namespace aoscore
