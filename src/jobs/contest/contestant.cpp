#include "jobs/contest/contestant.h"

#include "core/hash.h"
#include "jobs/contest/few_rays.h"
#include "jobs/contest/truth_image.h"
#include "jobs/draw_image.h"
#include "reference/truth.h"
#include "screen/method/depth_layers.h"
#include "screen/method/request_digest.h"
#include "store/code_digest.h"

#include <utility>

namespace aoscore {
namespace {

/// The common part of both contestants that a request describes.
class Requested : public Contestant {
  public:
    explicit Requested(MethodRequest request) : request_(std::move(request)) {}

    std::string digest(bool orthographic) const override { return request_digest(request_, orthographic); }
    std::optional<std::set<std::string>> gbuffer_inputs() const override {
        return needed_gbuffer_inputs(request_);
    }
    bool is_filtered() const override { return request_.filter != nullptr; }

  protected:
    const MethodRequest& request() const { return request_; }

  private:
    MethodRequest request_;
};

class ShaderMethod final : public Requested {
  public:
    using Requested::Requested;

    std::string_view code() const override { return "image"; }
    std::string digest(bool orthographic) const override {
        const std::string drawn = Requested::digest(orthographic);
        if (!reads_ray_layers(*request().method, request().parameters)) return drawn;
        return Digest().text(drawn).text(code_digest("ray_layers")).text(tracer_version()).hex();
    }
    std::vector<std::string> signals() const override { return request().signals; }
    const MethodRequest* timed_request() const override { return &request(); }
    ContestantImage image(const ContestantSources& sources) const override {
        return {draw_image(sources.tools.ready_renderer(), request()), {}};
    }
};

/// Few rays have no cost: rays on a processor say nothing about a graphics card's.
class FewRays final : public Requested {
  public:
    using Requested::Requested;

    std::string_view code() const override { return "few_rays"; }
    ContestantImage image(const ContestantSources& sources) const override {
        MethodOutput output;
        output.raw = trace_few_rays(sources.tools.reference(), sources.frame, request());
        output.visibility = sources.tools.ready_renderer().filter(output.raw, request());
        return {std::move(output), {}};
    }
};

/// The common part of both contestants that are a part of the truth.
class OfTruth : public Contestant {
  public:
    explicit OfTruth(const TruthQuery& query) : query_(query) {}

    std::string_view code() const override { return "truth_image"; }
    std::optional<TruthQuery> truth_query() const override { return query_; }

  private:
    TruthQuery query_;
};

class TrueImage final : public OfTruth {
  public:
    using OfTruth::OfTruth;

    std::string digest(bool) const override { return "true"; }
    ContestantImage image(const ContestantSources& sources) const override {
        const ImageF& visibility = true_visibility(*sources.truth, *truth_query());
        return {{visibility, visibility, {}, {}}, {}};
    }
};

class OneLayerBound final : public OfTruth {
  public:
    using OfTruth::OfTruth;

    std::string digest(bool) const override { return "one layer"; }
    ContestantImage image(const ContestantSources& sources) const override {
        const ImageF visibility = one_layer_visibility(*sources.truth);
        return {{visibility, visibility, {}, {}}, {}};
    }
};

}  // namespace

std::shared_ptr<const Contestant> contestant_of(MethodRequest request) {
    if (is_few_rays(request)) return std::make_shared<FewRays>(std::move(request));
    return std::make_shared<ShaderMethod>(std::move(request));
}

std::shared_ptr<const Contestant> true_image(const TruthQuery& query) {
    return std::make_shared<TrueImage>(query);
}

std::shared_ptr<const Contestant> one_layer_bound(const TruthQuery& query) {
    return std::make_shared<OneLayerBound>(query);
}

}  // namespace aoscore
