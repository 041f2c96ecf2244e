#pragma once

#include "core/temporary_folder.h"
#include "jobs/executor.h"
#include "jobs/view_maker.h"
#include "stress/stressed_cell.h"
#include "stress/unstressed.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// Makes the artifacts of one stressed view in this process, and stores those that its results consist of.
/// Their inputs come from a ViewMaker.
class StressMaker final : public Maker {
  public:
    /// All arguments must outlive this object.
    StressMaker(const StressWork& work, const ArtifactStore& store, Unstressed& unstressed);

    bool take(const Job& job) override;
    bool take_input(const Job& job) override;
    void make(const Job& job) override;
    std::vector<std::string> make_in_turns(std::span<const Job* const> jobs) override;

    // The artifacts that were taken or made; a cell is null where it has failed.
    const StressSettingRecord& setting() const { return setting_.value(); }
    const StressedCell* cell(const Key& key) const;
    /// Milliseconds of one run; empty where they are left out or have failed.
    std::optional<double> time_ms(const Key& key) const;

  private:
    void make_setting(const Job& job);
    void make_cell(const Job& job);
    void make_times(const Job& job);
    double timed_ms(const StressRequest& request);

    const StressWork& work_;
    const ArtifactStore& store_;
    Unstressed& unstressed_;
    ViewRecord described_;  ///< stays empty: there are no results of a score
    ViewMaker sources_;
    TemporaryFolder folder_;  ///< holds files until they are stored
    std::optional<StressSettingRecord> setting_;
    std::map<Key, StressedCell> cells_;
    std::map<Key, double> times_;  ///< of the cells and of the G-buffer
};

}  // namespace aoscore
