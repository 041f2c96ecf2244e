#pragma once

#include "reference/truth.h"
#include "screen/screen.h"
#include "stress/stress.h"
#include "stress/stress_axes.h"
#include "stress/stress_judge.h"
#include "stress/stress_subjects.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace aoscore {

/// Draws, traces and judges settings; keeps the unstressed results that all others are held against.
class StressRunner {
  public:
    StressRunner(const StressPlan& plan, const std::vector<StressSubject>& subjects);

    const ScreenRenderer& renderer() const { return renderer_; }

    /// One setting with all subjects; its thumbnails land in folder/settings/. `key` is left empty.
    StressSettingRecord run(const StressAxis& axis, const StressSetting& setting, const StressCase& stress,
                            const std::filesystem::path& folder);

  private:
    /// What a case looks like before any subject is run on it.
    struct Ground {
        Truth truth;  ///< without queries where the case has none
        GBufferImages gbuffer;
        Mask surface;  ///< in either path
        Mask valid;
        std::optional<double> disagreeing_share;
    };
    struct Unstressed {
        ImageF visibility;
        std::optional<double> rmse, mean;
    };
    struct Thumbnails;

    void enter(const Scene& scene);
    Ground ground(const StressAxis& axis, const StressCase& stress,
                  const std::vector<StressRequest>& requests, StressSettingRecord& record);
    std::vector<StressRequest> requests_for(const StressAxis& axis, const StressCase& stress,
                                            std::vector<StressCell>& cells) const;
    /// Runs the subject and counts what must hold for any picture.
    ImageF picture_of(const StressSubject& subject, const StressRequest& request, const Ground& ground,
                      StressCell& cell);
    void compare(const StressAxis& axis, const StressRequest& request, const Ground& ground,
                 const Unstressed& base, const ImageF& picture, StressCell& cell, ImageF& difference) const;
    const Unstressed& unstressed(const StressSubject& subject, const std::string& preset);
    void prepare_base();

    const StressPlan& plan_;
    const std::vector<StressSubject>& subjects_;
    ScreenRenderer renderer_;
    std::string entered_;  ///< digest of the scene that renderer and reference hold
    std::unique_ptr<ReferenceScene> reference_;
    std::optional<Ground> base_ground_;
    std::map<std::string, Unstressed> base_;  ///< by subject and preset
};

}  // namespace aoscore
