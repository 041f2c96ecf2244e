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

/// The pictures of all subjects where nothing is stressed, with which every stressed picture is compared;
/// those of presets that only a stressed view uses are among them. They are made when first needed, and kept
/// in memory.
class Unstressed {
  public:
    /// All arguments must outlive this object.
    Unstressed(const StressPlan& plan, const std::vector<StressSubject>& subjects, SceneTools& tools);

    /// The key of all pictures together.
    Key key() const;
    /// The key of the picture of the request's subject with its preset, and of that picture's truth.
    Key key(const StressRequest& request) const;

    bool made() const { return !pictures_.empty(); }
    /// Draws and traces all pictures. A subject that fails here fails in every comparison.
    void make(const ArtifactStore& store);
    /// The picture for a request. Throws internal_error where the subject has failed.
    const UnstressedPicture& of(const StressRequest& request) const;

  private:
    struct Made {
        UnstressedPicture picture;
        std::string error;  ///< why there is no picture; else empty
    };
    using Name = std::pair<std::string, std::string>;  ///< subject and preset
    static Name name_of(const StressRequest& request) { return {request.subject->id, request.preset}; }

    StressWork work_;
    ViewKeys keys_;
    std::map<Name, std::size_t> cells_;  ///< indices into the view's cells
    std::map<Name, Made> pictures_;
};

}  // namespace aoscore
