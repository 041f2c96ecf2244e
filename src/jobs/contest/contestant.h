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

/// What a contestant makes its image of: one view of the scene that the tools have chosen.
struct ContestantSources {
    SceneTools& tools;             ///< its renderer holds the G-buffer, where that is read
    const CameraFrame& frame;      ///< of the view
    const Truth* truth = nullptr;  ///< null where no truth is read
};

/// Whatever can be scored on a view: it gives an image of visibility, and has a cost or none. Behind it:
/// - ShaderMethod, a folder of shaders/methods/ drawn by the renderer. Passes that no shader can draw are
///   computed by a Processor (screen/passes/processors.h), the line sweep among them;
/// - FewRays, the ray tracer with as few rays as a frame has time for (jobs/contest/few_rays.h);
/// - FolderImage, an image that another program has left in a folder (jobs/contest/folder_image.h);
/// - TrueImage, the truth itself;
/// - OneLayerBound, the most occlusion that any method could find which knows one depth layer.
class Contestant {
  public:
    virtual ~Contestant() = default;

    /// The code that makes its image, by its name in code_digest().
    virtual std::string_view code() const = 0;
    /// Of all else that decides its image, beside what it reads.
    virtual std::string digest(bool orthographic) const = 0;
    /// The G-buffer's inputs that it reads; empty where it does not read the G-buffer at all.
    virtual std::optional<std::set<std::string>> gbuffer_inputs() const { return std::nullopt; }
    /// What it reads of the truth; empty where it does not read the truth.
    virtual std::optional<TruthQuery> truth_query() const { return std::nullopt; }
    /// Ids of the signals that it gives beside visibility (core/signal.h).
    virtual std::vector<std::string> signals() const { return {}; }
    /// What is timed, and whose fetches are counted; null for a contestant without a cost.
    virtual const MethodRequest* timed_request() const { return nullptr; }
    /// Whether a filter has made its image of a raw one, which it gives as well.
    virtual bool is_filtered() const { return false; }

    /// Its image, raw and filtered. Throws where there is none, or one that does not fit the view.
    virtual MethodOutput image(const ContestantSources& sources) const = 0;
};

/// A method, or few rays: what a request asks for.
std::shared_ptr<const Contestant> contestant_of(MethodRequest request);
/// The truth's visibility of this query.
std::shared_ptr<const Contestant> true_image(const TruthQuery& query);
/// Of the truth's first query, which this must be; the truth must be traced with its one-layer bound.
std::shared_ptr<const Contestant> one_layer_bound(const TruthQuery& query);

}  // namespace aoscore
