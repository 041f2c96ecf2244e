#include "plan/claims/claim_sources.h"

#include "core/error.h"
#include "core/source_reference.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <ranges>

namespace aoscore {

ClaimSources::ClaimSources(StrictObject& list) : where_(list.where("sources")) {
    if (list.has("source") == list.has("sources"))
        throw file_error("has both or neither of them", list.where(), "source, or sources");
    if (list.has("source")) {
        only_ = source_reference(list.object("source"));
        return;
    }
    for (const auto& [name, value] : list.object("sources").members())
        by_name_[name] = source_reference(StrictObject(value, where_ + "." + name));
    if (by_name_.empty()) throw file_error("is empty", where_, "a source for each name");
}

std::string ClaimSources::cited_by(StrictObject& claim) {
    if (by_name_.empty()) return only_;
    const std::string name = claim.text("source");
    const auto found = by_name_.find(name);
    if (found == by_name_.end()) {
        throw file_error("is " + name, claim.where("source"),
                         fmt::format("{}", fmt::join(std::views::keys(by_name_), ", ")));
    }
    cited_.insert(name);
    return found->second;
}

void ClaimSources::finish() const {
    for (const auto& [name, line] : by_name_) {
        if (!cited_.contains(name)) throw file_error("is cited by no claim", where_ + "." + name);
    }
}

}  // namespace aoscore
