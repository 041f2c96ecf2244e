#pragma once

#include "core/strict_json.h"

#include <map>
#include <set>
#include <string>

namespace aoscore {

/// The sources of a list of claims: one "source" for all of them, or "sources" by name, of which each claim
/// cites one.
class ClaimSources {
  public:
    /// Reads either from the list. Throws file_error for both, for neither, and where source_reference()
    /// does.
    explicit ClaimSources(StrictObject& list);

    /// The claim's source as a line. Throws file_error for a name that is not there.
    std::string cited_by(StrictObject& claim);

    /// Throws file_error for a source that no claim has cited.
    void finish() const;

  private:
    std::string only_;                            // the one for all claims
    std::map<std::string, std::string> by_name_;  // the several
    std::set<std::string> cited_;
    std::string where_;
};

}  // namespace aoscore
