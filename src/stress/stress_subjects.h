#pragma once

#include "jobs/contest/contestant.h"
#include "plan/resolved_cell.h"
#include "stress/stress_axes.h"
#include "stress/stress_case.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace aoscore {

/// A subject of the test: a method without filter, a filter over one method, the reference, or the one-layer
/// bound by the reference's rays.
struct StressSubject {
    std::string id, label, kind;               ///< kind: "method", "filter", "reference", "bound"
    const MethodDescriptor* method = nullptr;  ///< null for traced subjects
    const MethodDescriptor* filter = nullptr;

    /// The reasons why it breaks by its nature, by stress axis. A filter has its method's beside its own.
    std::map<std::string, std::string> limits() const;
};

/// The method whose output is filtered.
inline constexpr const char* kFilteredMethod = "gtao";

/// The reference, the bound, all filters and these methods, or all of them where none is named. `registry`
/// must outlive the result. Throws usage_error for an unknown method.
std::vector<StressSubject> stress_subjects(const Registry& registry, const std::vector<std::string>& methods);

/// The query of the truth for subjects that have none of their own.
TruthQuery reference_query(const StressCase& stress);

/// A subject's run in a case.
struct StressRequest {
    const StressSubject* subject = nullptr;
    std::shared_ptr<const Contestant> contestant;  ///< null where the subject is not run
    std::string preset = "default";
    TruthQuery own;
    std::string skipped;  ///< why the stress does not apply; empty where it is run
};
/// Throws usage_error where a scaled parameter leaves its range.
StressRequest stress_request(const StressSubject& subject, StressJudgement judgement,
                             const StressCase& stress, std::uint64_t seed);

}  // namespace aoscore
