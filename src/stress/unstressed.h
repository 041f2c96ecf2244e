#pragma once

#include "jobs/view_keys.h"
#include "store/artifact_store.h"
#include "stress/stress_judge.h"
#include "stress/stress_work.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace aoscore {

/// What all subjects show where nothing is stressed, which every stressed picture is held against; also with
/// the presets that only a stressed view uses. Made when first needed, and kept in memory.
class Unstressed {
  public:
    /// All of them must outlive it.
    Unstressed(const StressPlan& plan, const std::vector<StressSubject>& subjects, SceneTools& tools);

    /// Of all pictures together.
    Key key() const;
    /// Of the picture that the request's subject shows with its preset, and of what it is held against.
    Key key(const StressRequest& request) const;

    bool made() const { return !pictures_.empty(); }
    /// Draws and traces all pictures. A subject that fails here fails wherever it is held against this.
    void make(const ArtifactStore& store);
    /// Throws internal_error where the subject has failed.
    const UnstressedPicture& of(const StressRequest& request) const;

  private:
    struct Made {
        UnstressedPicture picture;
        std::string error;  ///< why there is no picture; empty where there is one
    };
    using Name = std::pair<std::string, std::string>;  ///< of subject and preset
    static Name name_of(const StressRequest& request) { return {request.subject->id, request.preset}; }

    StressWork work_;
    ViewKeys keys_;
    std::map<Name, std::size_t> cells_;  ///< of the work's view
    std::map<Name, Made> pictures_;
};

}  // namespace aoscore
