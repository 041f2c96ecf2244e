#pragma once

#include "core/image.h"
#include "jobs/scene_tools.h"
#include "screen/screen.h"

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// The inputs of a contestant's image: one view of the scene that the tools have chosen.
struct ContestantSources {
    SceneTools& tools;             ///< their renderer holds the G-buffer, where that is read
    const CameraFrame& frame;      ///< the view's frame
    const Truth* truth = nullptr;  ///< null where no truth is read
    const Scene* scene = nullptr;  ///< where it is read
    std::string view = {};         ///< the view's id
};

/// The cost that another program reports of itself. It never stands beside times that were measured here.
struct ReportedCost {
    double ms = 0;
    std::string on;  ///< what it was measured on
};

/// A contestant's image, raw and filtered.
struct ContestantImage : MethodOutput {
    std::optional<ReportedCost> cost;
};

/// Anything that can be scored on a view: it gives an image of visibility, and may have a cost.
/// Implementations:
/// - ShaderMethod, a folder of shaders/methods/ drawn by the renderer. Passes that no shader can draw are
///   computed by a Processor (screen/passes/processors.h), the line sweep among them;
/// - FewRays, the ray tracer with as few rays as a frame has time for (jobs/contest/few_rays.h);
/// - FolderImage, an image that another program has left in a folder (jobs/contest/folder_image.h);
/// - CommandImage, an image that another program makes when it is asked (jobs/contest/command_image.h);
/// - TrueImage, the truth itself;
/// - OneLayerBound, the most occlusion that any method could find which knows one depth layer.
class Contestant {
  public:
    virtual ~Contestant() = default;

    /// The kind in code_digest() of the code that makes its image.
    virtual std::string_view code() const = 0;
    /// The digest of all that decides its image beside the inputs that it reads.
    virtual std::string digest(bool orthographic) const = 0;
    /// The G-buffer's inputs that it reads; empty where it does not read the G-buffer at all.
    virtual std::optional<std::set<std::string>> gbuffer_inputs() const { return std::nullopt; }
    /// The query of the truth that it reads; empty where it does not read the truth.
    virtual std::optional<TruthQuery> truth_query() const { return std::nullopt; }
    /// The ids of the signals that it gives beside visibility (core/signal.h).
    virtual std::vector<std::string> signals() const { return {}; }
    /// The request to time, and whose fetches are counted; null for a contestant without a cost.
    virtual const MethodRequest* timed_request() const { return nullptr; }
    /// Whether its image is filtered; it then gives the raw one as well.
    virtual bool is_filtered() const { return false; }

    /// Its image, raw and filtered. Throws where there is none, or one that does not fit the view.
    virtual ContestantImage image(const ContestantSources& sources) const = 0;
};

/// Makes the contestant of a request: a method, or few rays.
std::shared_ptr<const Contestant> contestant_of(MethodRequest request);
/// Makes a contestant of the truth's visibility for this query.
std::shared_ptr<const Contestant> true_image(const TruthQuery& query);
/// Makes the contestant of the one-layer bound. `query` must be the truth's first, traced with its one-layer
/// bound.
std::shared_ptr<const Contestant> one_layer_bound(const TruthQuery& query);

}  // namespace aoscore
