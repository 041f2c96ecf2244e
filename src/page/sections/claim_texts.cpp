#include "page/sections/claim_texts.h"

#include "core/counted.h"
#include "page/document/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace aoscore {
namespace {

struct Style {
    std::string_view verdict, style;
};
constexpr std::array kStyles{Style{ClaimRecord::kHolds, "holds"}, Style{ClaimRecord::kFails, "fails"},
                             Style{ClaimRecord::kCannotTell, "open"}};

std::string with_unit(std::optional<double> value, const ClaimFinding& finding) {
    return fixed_text(value, finding.decimals) + (finding.unit.empty() ? "" : " " + finding.unit);
}

}  // namespace

std::string verdict_style(const std::string& verdict) {
    const auto found = std::ranges::find(kStyles, verdict, &Style::verdict);
    return std::string(found == kStyles.end() ? kStyles.back().style : found->style);
}

std::string measured_text(const ClaimFinding& finding) {
    std::string text = with_unit(finding.value, finding);
    if (finding.low && finding.high && *finding.low != *finding.high) {
        text += fmt::format(" ({} to {})", fixed_text(finding.low, finding.decimals),
                            fixed_text(finding.high, finding.decimals));
    }
    return text;
}

std::string claimed_text(const ClaimFinding& finding) {
    // A limit of -0, the mirror image of 0, is written as 0.
    const auto text = [](double limit) { return short_text(limit == 0 ? 0.0 : limit); };
    if (finding.claimed_low && finding.claimed_high)
        return fmt::format("{} to {}", text(*finding.claimed_low), text(*finding.claimed_high));
    if (finding.claimed_low) return "above " + text(*finding.claimed_low);
    return finding.claimed_high ? "below " + text(*finding.claimed_high) : "";
}

std::string verdict_counts_text(std::size_t claims, std::size_t hold, std::size_t fail) {
    return fmt::format("of {}, {}, {} and {} cannot be told here", counted(claims, "claim", "claims"),
                       counted(hold, "holds", "hold"), counted(fail, "does not hold", "do not hold"),
                       claims - hold - fail);
}

std::string deciding_text(const ClaimRecord& claim) {
    const auto found = std::ranges::find(claim.findings, claim.verdict, &ClaimFinding::outcome);
    if (found == claim.findings.end()) return claim.reason;
    std::string text = found->about.empty() ? found->what : fmt::format("{}: {}", found->about, found->what);
    text += fmt::format(": {}, claimed {}", measured_text(*found), claimed_text(*found));
    if (claim.findings.size() > 1) text += fmt::format(" (the first of {} parts)", claim.findings.size());
    return text;
}

}  // namespace aoscore
