#include "metrics/roles.h"
#include "page/document/number_text.h"
#include "page/section.h"
#include "page/sections/claim_texts.h"
#include "results/ranked_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace aoscore {
namespace {

using nlohmann::json;

json finding_model(const ClaimFinding& finding) {
    return {{"about", finding.about},
            {"has_about", !finding.about.empty()},
            {"what", finding.what},
            {"measured", measured_text(finding)},
            {"claimed", claimed_text(finding)},
            {"outcome", finding.outcome},
            {"style", verdict_style(finding.outcome)}};
}

/// The errors against the truth of the cells that a claim was measured on.
json error_models(const ClaimRecord& claim, const Results& results) {
    json list = json::array();
    for (const std::string& id : claim.cell_ids) {
        const CellRecord* cell = find_cell(results, id);
        if (cell == nullptr) continue;
        list.push_back({{"cell", id},
                        {"error", fixed_text(ranked_value(*cell, kRankingMetric), 4)},
                        {"bias", fixed_text(ranked_value(*cell, kBiasMetric), 4)},
                        {"ssim", fixed_text(ranked_value(*cell, kStructureMetric), 4)}});
    }
    return list;
}

/// How many of a claim's parts hold, such as "4 of 6".
std::string parts_text(const ClaimRecord& claim) {
    if (claim.findings.empty()) return std::string(kNoNumber);
    const auto holding = std::ranges::count(claim.findings, ClaimRecord::kHolds, &ClaimFinding::outcome);
    return fmt::format("{} of {}", holding, claim.findings.size());
}

json claim_model(const ClaimRecord& claim, const Results& results) {
    json model = {{"id", claim.id},
                  {"place", claim.place},
                  {"claim", claim.claim},
                  {"verdict", claim.verdict},
                  {"style", verdict_style(claim.verdict)},
                  {"parts", parts_text(claim)},
                  {"reason", claim.reason},
                  {"has_reason", !claim.reason.empty()},
                  {"own", claim.own},
                  {"has_own", !claim.own.empty()},
                  {"note", claim.note},
                  {"has_note", !claim.note.empty()},
                  {"findings", json::array()},
                  {"errors", error_models(claim, results)}};
    for (const ClaimFinding& finding : claim.findings) model["findings"].push_back(finding_model(finding));
    model["has_findings"] = !claim.findings.empty();
    model["has_errors"] = !model["errors"].empty();
    return model;
}

json counts(const std::map<std::string, std::size_t>& by_verdict, std::size_t total) {
    json list = json::array();
    for (const std::string verdict : {ClaimRecord::kHolds, ClaimRecord::kFails, ClaimRecord::kCannotTell}) {
        const auto found = by_verdict.find(verdict);
        list.push_back({{"verdict", verdict},
                        {"style", verdict_style(verdict)},
                        {"count", std::to_string(found == by_verdict.end() ? 0 : found->second)}});
    }
    list.push_back({{"verdict", "all"}, {"style", "all"}, {"count", std::to_string(total)}});
    return list;
}

}  // namespace

json section::claims(const PageSource& source) {
    std::vector<std::string> order;
    std::map<std::string, std::vector<const ClaimRecord*>> by_source;
    for (const ClaimRecord& claim : source.results.claims) {
        if (!by_source.contains(claim.source)) order.push_back(claim.source);
        by_source[claim.source].push_back(&claim);
    }
    json model = {{"sources", json::array()}, {"several", source.results.claims.size() > 1}};
    std::map<std::string, std::size_t> overall;
    for (const std::string& name : order) {
        std::map<std::string, std::size_t> by_verdict;
        json claims = json::array();
        for (const ClaimRecord* claim : by_source[name]) {
            ++by_verdict[claim->verdict];
            ++overall[claim->verdict];
            claims.push_back(claim_model(*claim, source.results));
        }
        model["sources"].push_back(
            {{"source", name}, {"counts", counts(by_verdict, claims.size())}, {"claims", claims}});
    }
    model["overall"] = counts(overall, source.results.claims.size());
    std::string counted_text = verdict_counts_text(source.results.claims.size(), overall[ClaimRecord::kHolds],
                                                   overall[ClaimRecord::kFails]);
    counted_text.front() = 'O';
    model["in_short"] = counted_text + ".";
    return model;
}

}  // namespace aoscore
