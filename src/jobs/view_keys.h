#pragma once

#include "jobs/view_work.h"
#include "store/key.h"

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>

namespace aoscore {

/// The keys of a view's artifacts. Each says what its artifact depends on, and nothing more: a time not on
/// the truth, a picture not on the number of rays, a score not on the machine.
class ViewKeys {
  public:
    /// `work` must outlive it.
    explicit ViewKeys(const ViewWork& work) : work_(work) {}

    Key gbuffer(const std::set<std::string>& inputs) const;
    Key gbuffer_times() const;
    /// The key of these queries of the view's truth.
    Key truth(std::span<const TruthQuery> queries) const;
    /// The key of the truth that has a method's own query.
    Key own_truth(const TruthQuery& query) const;
    /// The key of all queries that are traced apart from the view's.
    Key own_truths() const;
    Key contract() const;
    Key view() const;
    Key truth_file() const;
    Key gbuffer_file() const;
    Key image(const CellWork& cell) const;
    Key score(const CellWork& cell) const;
    Key own_score(const CellWork& cell) const;
    Key fetches(const CellWork& cell) const;
    Key irradiance() const;
    Key view_light() const;
    Key light(const CellWork& cell) const;
    Key lit_file(const CellWork& cell) const;
    Key repeats(const CellWork& cell) const;
    Key times(const CellWork& cell) const;

  private:
    bool orthographic() const;
    const std::string& albedo() const;
    const std::string& fixed_pass() const;
    const std::string& environment() const;
    KeyBuilder timed(std::string_view kind) const;

    const ViewWork& work_;
    // Slow digests, computed once.
    mutable std::optional<std::string> albedo_, fixed_pass_, environment_;
    mutable std::map<const CellWork*, Key> images_;
};

}  // namespace aoscore
