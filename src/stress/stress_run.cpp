#include "stress/stress_run.h"

#include "core/error.h"
#include "core/interrupt.h"
#include "jobs/camera_contract.h"
#include "stress/stress_thumbnails.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>

namespace aoscore {
namespace {

constexpr const char* kBase = "base";
// The reference is looked at with this radius where no method asks for another, metres in the base.
constexpr double kRadius_m = 0.5;

TruthQuery reference_query(const StressCase& stress) {
    return {Falloff::binary, kRadius_m * stress.length_scale * stress.radius_scale, 0};
}

Mask either(const Mask& a, const Mask& b) {
    Mask result = a;
    for (std::size_t i = 0; i < b.size(); ++i) result.pixels[i] |= b.pixels[i];
    return result;
}

std::size_t count_of(const Mask& mask) {
    return static_cast<std::size_t>(std::count(mask.pixels.begin(), mask.pixels.end(), 1));
}

// Of the scene before it was moved: what float32 had to hold.
double extent_of(const Scene& scene) {
    return std::max(glm::length(scene.bounds.low), glm::length(scene.bounds.high));
}

ImageF inverse(const ImageF& occlusion) {
    ImageF visibility = occlusion;
    for (float& v : visibility.pixels) v = 1 - v;
    return visibility;
}

std::size_t query_index(const Truth& truth, const TruthQuery& query) {
    const auto found = std::find(truth.queries.begin(), truth.queries.end(), query);
    if (found == truth.queries.end()) throw internal_error("a truth was not traced", "stress");
    return static_cast<std::size_t>(found - truth.queries.begin());
}

}  // namespace

StressRunner::StressRunner(const StressPlan& plan, const std::vector<StressSubject>& subjects)
    : plan_(plan), subjects_(subjects) {}

void StressRunner::enter(const Scene& scene) {
    if (entered_ == scene.digest) return;
    reference_ = std::make_unique<ReferenceScene>(scene);
    renderer_.set_scene(scene);
    entered_ = scene.digest;
}

std::vector<StressRequest> StressRunner::requests_for(const StressAxis& axis, const StressCase& stress,
                                                      std::vector<StressCell>& cells) const {
    std::vector<StressRequest> requests;
    for (const StressSubject& subject : subjects_) {
        StressCell cell;
        cell.subject = subject.id;
        requests.emplace_back();
        try {
            requests.back() = stress_request(subject, stress, plan_.seed);
            cell.skipped = requests.back().skipped;
            if (subject.method == nullptr) requests.back().own = reference_query(stress);
            if (subject.method == nullptr && !stress.has_truth) cell.skipped = "is not traced here";
            if (subject.kind == "bound" && axis.judgement == StressJudgement::same_picture)
                cell.skipped = "is traced where the picture changes";
        } catch (const Error& e) {
            cell.error = e.what();
        }
        cells.push_back(std::move(cell));
    }
    return requests;
}

StressRunner::Ground StressRunner::ground(const StressAxis& axis, const StressCase& stress,
                                          const std::vector<StressRequest>& requests,
                                          StressSettingRecord& record) {
    enter(stress.scene);
    const CameraFrame frame(stress.camera, stress.width, stress.height);
    std::set<std::string> inputs;
    std::vector<TruthQuery> queries{reference_query(stress)};
    for (const StressRequest& request : requests) {
        if (!request.request) continue;
        inputs.merge(needed_gbuffer_inputs(*request.request));
        if (std::find(queries.begin(), queries.end(), request.own) == queries.end())
            queries.push_back(request.own);
    }
    Ground result;
    record.gbuffer_ms = renderer_.draw_gbuffer(frame, inputs);
    result.gbuffer = renderer_.read_gbuffer();
    if (!stress.has_truth) {
        result.surface = result.valid = result.gbuffer.surface;
        return result;
    }
    TruthSettings settings;
    settings.samples = plan_.samples;
    settings.seed = plan_.seed;
    settings.extras.one_layer_bound = axis.judgement == StressJudgement::error;
    result.truth = reference_->trace(frame, queries, settings, "truth");
    const CameraContract contract =
        check_camera_contract(frame, result.truth.hits, result.gbuffer, extent_of(stress.scene));
    result.surface = either(result.truth.hits.surface, result.gbuffer.surface);
    result.valid = contract.valid;
    result.disagreeing_share = contract.disagreeing_share();
    record.truth_samples = plan_.samples;
    record.truth_seconds = result.truth.seconds;
    return result;
}

ImageF StressRunner::picture_of(const StressSubject& subject, const StressRequest& request,
                                const Ground& ground, StressCell& cell) {
    ImageF picture;
    const Mask* surface = &ground.gbuffer.surface;
    if (subject.method == nullptr) {
        picture = subject.kind == "bound" ? inverse(ground.truth.one_layer_bound)
                                          : ground.truth.visibility[query_index(ground.truth, request.own)];
        surface = &ground.truth.hits.surface;
        if (subject.kind == "reference") cell.time_ms = 1000 * ground.truth.seconds;
    } else {
        picture = renderer_.run(*request.request).visibility;
        const ScreenRenderer::PassTimes times = renderer_.time(*request.request);
        cell.time_ms = times.filter_ms ? *times.filter_ms : times.ao_ms;
    }
    count_faults({picture, *surface, ground.valid}, cell);
    return picture;
}

// Deviation and what it comes from.
void StressRunner::compare(const StressAxis& axis, const StressRequest& request, const Ground& ground,
                           const Unstressed& base, const ImageF& picture, StressCell& cell,
                           ImageF& difference) const {
    StressedPicture stressed{picture, ground.surface, ground.valid};
    if (ground.truth.queries.empty()) {
        if (cell.mean && base.mean) cell.deviation = std::abs(*cell.mean - *base.mean);
        return;
    }
    if (axis.judgement == StressJudgement::same_picture) {
        cell.deviation = same_picture_deviation(stressed, base.visibility, base_ground_->valid, difference);
        return;
    }
    const std::size_t q = query_index(ground.truth, request.own);
    stressed.truth = &ground.truth.visibility[q];
    stressed.standard_error = &ground.truth.standard_error[q];
    cell.rmse = debiased_error(stressed, difference);
    if (cell.rmse && base.rmse) cell.deviation = *cell.rmse - *base.rmse;
}

void StressRunner::prepare_base() {
    if (base_ground_) return;
    const StressCase base = stress_case({kBase, "", {}}, plan_.size);
    // Presets that only a stressed setting uses have an unstressed result too.
    StressCase performance = base;
    performance.performance_presets_only = true;
    std::vector<StressRequest> all;
    std::vector<StressCell> cells, unused;
    const StressAxis axis{kBase, "", "", StressJudgement::error, {}};
    const std::vector<StressRequest> usual = requests_for(axis, base, cells);
    const std::vector<StressRequest> fast = requests_for(axis, performance, unused);
    all.insert(all.end(), usual.begin(), usual.end());
    all.insert(all.end(), fast.begin(), fast.end());
    StressSettingRecord record;
    base_ground_ = ground(axis, base, all, record);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const StressSubject& subject = subjects_[i % subjects_.size()];
        if (subject.method != nullptr && !all[i].request) continue;
        throw_if_interrupted();
        StressCell cell;
        Unstressed result;
        result.visibility = picture_of(subject, all[i], *base_ground_, cell);
        ImageF difference;
        compare(axis, all[i], *base_ground_, result, result.visibility, cell, difference);
        result.rmse = cell.rmse;
        result.mean = cell.mean;
        base_[subject.id + "/" + all[i].preset] = std::move(result);
    }
}

const StressRunner::Unstressed& StressRunner::unstressed(const StressSubject& subject,
                                                         const std::string& preset) {
    return base_.at(subject.id + "/" + preset);
}

StressSettingRecord StressRunner::run(const StressAxis& axis, const StressSetting& setting,
                                      const StressCase& stress, const std::filesystem::path& folder) {
    prepare_base();
    const auto start = std::chrono::steady_clock::now();
    StressSettingRecord record;
    record.id = setting.id;
    record.label = setting.label;
    record.unstressed = setting.unstressed();
    record.width = stress.width;
    record.height = stress.height;
    record.triangles = stress.scene.triangle_count;
    const std::vector<StressRequest> requests = requests_for(axis, stress, record.cells);
    const Ground here = ground(axis, stress, requests, record);
    record.surface_pixels = count_of(here.surface);
    record.compared_pixels = count_of(here.valid);
    record.disagreeing_share = here.disagreeing_share;
    StressThumbnails thumbnails;
    for (std::size_t i = 0; i < subjects_.size(); ++i) {
        throw_if_interrupted();
        StressCell& cell = record.cells[i];
        if (!cell.skipped.empty()) continue;
        ImageF picture, difference;
        try {
            if (cell.error.empty()) {
                picture = picture_of(subjects_[i], requests[i], here, cell);
                compare(axis, requests[i], here, unstressed(subjects_[i], requests[i].preset), picture, cell,
                        difference);
            }
        } catch (const Error& e) {
            if (e.exit_code() == ExitCode::interrupted) throw;
            cell.error = e.what();
        }
        judge(axis.judgement, cell);
        if (subjects_[i].kind == "reference" && cell.breaks.empty() &&
            here.disagreeing_share.value_or(0) > CameraContract::kTolerated) {
            cell.breaks = fmt::format("sees other surfaces than the rasteriser on {:.1f} % of the pixels",
                                      100 * *here.disagreeing_share);
        }
        thumbnails.add(subjects_[i].id, picture, difference);
    }
    // Where no subject applies there is no picture.
    if (!thumbnails.empty()) {
        record.images = fmt::format("settings/{}/{}.exr", axis.id, setting.id);
        thumbnails.write(folder / record.images);
    }
    record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return record;
}

}  // namespace aoscore
