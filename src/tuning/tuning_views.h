#pragma once

#include "jobs/ground.h"
#include "plan/ranking_radius.h"
#include "reference/truth.h"
#include "scene/scene.h"
#include "screen/screen.h"
#include "store/key.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace aoscore {

/// A view that settings are tuned on, ready for any number of images: its truth, the pixels that count, and
/// its G-buffer, which the renderer keeps.
struct TuningView {
    std::string key;    ///< "atrium/wide"
    std::string scene;  ///< the scene's id
    RankingRadius radius;
    Truth truth;
    Ground ground;  ///< refers to `truth`
    std::size_t gbuffer = 0;
    bool orthographic = false;
    Key made_of;  ///< the key of truth and G-buffer
};

/// The view to make ready.
struct TuningViewPlan {
    const Scene* scene = nullptr;
    View view;
    int width = 0, height = 0;
    int samples = 64;  ///< truth's rays a pixel, an even number: its halves leave the RMSE without bias
    std::optional<double> radius_m;
};

/// Traces the view's truth, or takes it from the cache, and draws its G-buffer with these inputs. The scene
/// must be the renderer's. Throws gate_failed where no pixel can be compared.
std::unique_ptr<TuningView> ready_view(const TuningViewPlan& plan, const ReferenceScene& reference,
                                       ScreenRenderer& renderer, const std::set<std::string>& inputs,
                                       const std::filesystem::path& truth_cache, const std::string& command);

}  // namespace aoscore
