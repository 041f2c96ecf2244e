#include "jobs/view_maker.h"

#include "core/error.h"
#include "core/log.h"
#include "image/image_file.h"
#include "jobs/draw_image.h"
#include "jobs/recorded/recorded_view.h"
#include "jobs/time_requests.h"
#include "jobs/view_files.h"
#include "jobs/view_record.h"

#include <fmt/format.h>

namespace aoscore {
namespace {

template <class Map>
const typename Map::mapped_type* found_in(const Map& map, const Key& key) {
    const auto found = map.find(key);
    return found == map.end() ? nullptr : &found->second;
}

double number_from(const nlohmann::json& payload, const std::string& where) {
    if (!payload.is_number()) throw file_error("is no number", where);
    return payload.get<double>();
}

}  // namespace

ViewMaker::ViewMaker(const ViewWork& work, const ViewJobs& jobs, const ArtifactStore& store,
                     const ViewRecord& view)
    : work_(work), store_(store), described_(view), frame_(work.frame()) {
    for (std::size_t i = 0; i < work.cells.size(); ++i) {
        if (work.cells[i].keep_image) pictured_.insert(jobs.cells[i].image);
    }
}

const Score* ViewMaker::score(const Key& key) const {
    return found_in(scores_, key);
}

const OwnScore* ViewMaker::own_score(const Key& key) const {
    return found_in(own_scores_, key);
}

const double* ViewMaker::fetches(const Key& key) const {
    return found_in(fetches_, key);
}

const Repeats* ViewMaker::repeats(const Key& key) const {
    return found_in(repeats_, key);
}

const LightErrors* ViewMaker::light(const Key& key) const {
    return found_in(lights_, key);
}

const StoredTimes* ViewMaker::times(const Key& key) const {
    return found_in(times_, key);
}

bool ViewMaker::take(const Job& job) {
    switch (job.kind) {
        case ArtifactKind::truth_file:
            return store_.fetch_file(job.key.hex, work_.folder / work_.truth_file());
        case ArtifactKind::gbuffer_file:
            return store_.fetch_file(job.key.hex, work_.folder / work_.gbuffer_file());
        case ArtifactKind::image:
            return store_.fetch_file(job.key.hex, work_.folder / work_.image_file(cell(job)));
        case ArtifactKind::irradiance:
            return store_.fetch_file(job.key.hex, work_.folder / work_.irradiance_file());
        case ArtifactKind::lit_file:
            return store_.fetch_file(job.key.hex, work_.folder / work_.lit_file(cell(job)));
        default:
            return take_payload(job);
    }
}

// Takes an artifact from the store; a damaged or foreign entry counts as missing.
bool ViewMaker::take_payload(const Job& job) {
    const std::optional<nlohmann::json> payload = store_.find(job.key.hex);
    if (!payload) return false;
    try {
        read_payload(job, *payload);
    } catch (const Error& e) {
        log_warning(std::string(e.what()) + "; measured again");
        return false;
    }
    if (job.kind != ArtifactKind::times) return true;
    return times_.at(job.key).serve(work_.timing_goal, cell(job).whole_frames);
}

void ViewMaker::read_payload(const Job& job, const nlohmann::json& payload) {
    const std::string& where = job.key.hex;
    switch (job.kind) {
        case ArtifactKind::gbuffer_times:
            gbuffer_runs_ = pass_runs_from_json(payload, where);
            break;
        case ArtifactKind::view:
            view_ = view_record_from_json(payload, where);
            view_->truth_origin =
                origin_id(work_.recorded != nullptr ? TruthOrigin::given : TruthOrigin::cached);
            view_->truth_rays_now = 0;
            view_->savings.left_out_triangles = 0;
            break;
        case ArtifactKind::score:
            scores_[job.key] = score_from_json(payload, where);
            break;
        case ArtifactKind::own_score:
            own_scores_[job.key] = own_score_from_json(payload, where);
            break;
        case ArtifactKind::fetches:
            fetches_[job.key] = number_from(payload, where);
            break;
        case ArtifactKind::times:
            times_[job.key] = stored_times_from_json(payload, where);
            break;
        case ArtifactKind::repeats:
            repeats_[job.key] = repeats_from_json(payload, where);
            break;
        case ArtifactKind::view_light:
            view_light_ = light_record_from_json(payload, where);
            break;
        case ArtifactKind::light:
            lights_[job.key] = light_errors_from_json(payload, where);
            break;
        default:
            throw internal_error("is kept in no entry of its own", std::string(id_of(job.kind)));
    }
}

bool ViewMaker::take_input(const Job& job) {
    switch (job.kind) {
        case ArtifactKind::gbuffer:
            return gbuffer_.has_value();
        case ArtifactKind::truth:
            return truth_.has_value();
        case ArtifactKind::own_truth:
            return own_truth_.has_value();
        case ArtifactKind::contract:
            return ground_.has_value();
        case ArtifactKind::irradiance:
            return take_irradiance(job);
        case ArtifactKind::image:
            return take_image(job);
        default:
            throw internal_error("is nobody's input", std::string(id_of(job.kind)));
    }
}

bool ViewMaker::take_irradiance(const Job& job) {
    if (irradiance_) return true;
    const std::optional<std::filesystem::path> file = store_.file(job.key.hex);
    if (file) irradiance_ = irradiance_of(read_image(*file));
    return irradiance_.has_value();
}

bool ViewMaker::take_image(const Job& job) {
    if (image_ && image_->first == job.key) return true;
    const std::optional<std::filesystem::path> file = store_.file(job.key.hex);
    if (!file) return false;
    const ImageFile kept = read_image(*file);
    const ImageF *visibility = kept.channel("Y"), *raw = kept.channel("raw.Y");
    if (visibility == nullptr) return false;
    ContestantImage output{{raw != nullptr ? *raw : *visibility, *visibility, {}, {}}, reported_cost(kept)};
    for (const std::string& id : cell(job).contestant->signals()) {
        for (const std::string_view channel : signal(id).channels) {
            const ImageF* plane = kept.channel(std::string(channel));
            if (plane == nullptr) return false;
            output.signals[id].push_back(*plane);
        }
    }
    image_.emplace(job.key, std::move(output));
    return true;
}

void ViewMaker::make(const Job& job) {
    switch (job.kind) {
        case ArtifactKind::gbuffer_times:
            draw(work_.read_inputs());
            gbuffer_runs_ = time_gbuffer(work_.tools.ready_renderer(), drawn_ms_);
            return keep(job, to_json(*gbuffer_runs_));
        case ArtifactKind::gbuffer:
            draw(work_.drawn_inputs());
            gbuffer_ = work_.recorded != nullptr ? work_.recorded->gbuffer
                                                 : work_.tools.ready_renderer().read_gbuffer();
            return;
        case ArtifactKind::truth:
            truth_ = trace(work_.truth_request(), "truth " + work_.key);
            return;
        case ArtifactKind::own_truth:
            own_truth_ = trace(work_.own_truth_request(), "methods' own truths " + work_.key);
            return;
        case ArtifactKind::contract:
            ground_ = work_.recorded != nullptr
                          ? recorded_ground(frame_, *work_.recorded)
                          : find_ground(frame_, truth_->truth, *gbuffer_, work_.scene.bounds);
            truth_side_.reset();
            return;
        case ArtifactKind::view:
            view_ = recorded_view(work_, described_, *truth_, *ground_);
            return keep(job, to_json(*view_));
        case ArtifactKind::truth_file:
            write_truth_file(work_, *truth_, *ground_);
            return store_.put_file(job.key.hex, work_.folder / work_.truth_file());
        case ArtifactKind::gbuffer_file:
            return make_gbuffer_file(job);
        case ArtifactKind::image:
            return make_image(job);
        case ArtifactKind::score:
            return make_score(job);
        case ArtifactKind::own_score:
            return make_own_score(job);
        case ArtifactKind::fetches:
            fetches_[job.key] =
                fetches_per_pixel(work_.tools.ready_renderer(), *cell(job).contestant->timed_request(),
                                  ground_->contract.valid);
            return keep(job, fetches_[job.key]);
        case ArtifactKind::repeats:
            return make_repeats(job);
        case ArtifactKind::irradiance:
            return make_irradiance(job);
        case ArtifactKind::view_light:
            return make_view_light(job);
        case ArtifactKind::light:
            return make_light(job);
        case ArtifactKind::lit_file:
            return make_lit_file(job);
        default:
            throw internal_error("is not made by itself", std::string(id_of(job.kind)));
    }
}

void ViewMaker::make_gbuffer_file(const Job& job) {
    std::vector<SurfaceLayer> surfaces;
    if (work_.keeps_surfaces()) {
        draw(work_.drawn_inputs());
        surfaces = work_.tools.ready_renderer().read_surfaces();
    }
    write_gbuffer_file(work_, *gbuffer_, surfaces);
    store_.put_file(job.key.hex, work_.folder / work_.gbuffer_file());
}

void ViewMaker::draw(const std::set<std::string>& inputs) {
    if (work_.recorded != nullptr)
        return work_.tools.renderer().take_gbuffer(frame_, work_.recorded->gbuffer, inputs);
    if (drawn_ms_ > 0 && drawn_inputs_ == inputs) return;
    drawn_ms_ = work_.tools.ready_renderer().draw_gbuffer(frame_, inputs);
    drawn_inputs_ = inputs;
}

// Traces the request, whose queries share their rays.
CachedTruth ViewMaker::trace(TruthRequest request, const std::string& what) {
    if (work_.recorded != nullptr) return {work_.recorded->truth, TruthOrigin::given, std::move(request)};
    const ReferenceScene& reference = work_.tools.reference();
    request.build = reference.build();
    const TruthLabel label{scene_name(work_.scene), work_.view.id, work_.command};
    CachedTruth traced = trace_truth(work_.truth_cache, reference, request, label, what);
    if (traced.origin != TruthOrigin::cached) rays_ += traced.truth.rays_now;
    return traced;
}

void ViewMaker::make_image(const Job& job) {
    const CellWork& work = cell(job);
    const Truth* truth = truth_ ? &truth_->truth : nullptr;
    image_.emplace(job.key,
                   work.contestant->image({work_.tools, frame_, truth, &work_.scene, work_.view.id}));
    if (!pictured_.contains(job.key)) return;
    write_image_file(work_, work, image_->second);
    store_.put_file(job.key.hex, work_.folder / work_.image_file(work));
}

void ViewMaker::make_score(const Job& job) {
    const ScoreSettings settings{cell(job).contestant->is_filtered(), work_.mask_threshold, work_.seed,
                                 work_.untold};
    if (!truth_side_) truth_side_.emplace(truth_->truth, *ground_);
    Score& score = scores_[job.key] =
        score_image(truth_->truth, *ground_, *truth_side_, image_->second, settings);
    if (!score.error().empty()) throw internal_error(score.error());
    if (const std::optional<ReportedCost>& cost = image_->second.cost) {
        score.reported_ms = cost->ms;
        score.reported_on = cost->on;
    }
    keep(job, to_json(score));
}

void ViewMaker::make_irradiance(const Job& job) {
    irradiance_ = trace_irradiance(work_.scene, frame_, *work_.environment, work_.radius_m, IrradianceGoal{},
                                   work_.seed);
    write_irradiance_file(work_, *irradiance_);
    store_.put_file(job.key.hex, work_.folder / work_.irradiance_file());
}

EnvironmentLight ViewMaker::light() {
    if (!cones_) cones_.emplace(*work_.environment);
    return {*cones_, frame_, truth_->truth.hits.normal};
}

void ViewMaker::make_view_light(const Job& job) {
    view_light_ = light_record(light(), *work_.environment, truth_->truth, *irradiance_,
                               ground_->contract.valid, work_.seed);
    keep(job, to_json(*view_light_));
}

void ViewMaker::make_light(const Job& job) {
    const LightErrors& errors = lights_[job.key] =
        light_errors(light(), image_->second, *irradiance_, ground_->contract.valid, work_.seed);
    keep(job, to_json(errors));
}

void ViewMaker::make_lit_file(const Job& job) {
    std::vector<LitPicture> pictures;
    for (const LightMode& mode : light_modes()) {
        if (!applies(mode, image_->second)) continue;
        // All that is seen is lit, edges too, on which no error is counted.
        pictures.push_back({mode, lit_image(mode, light(), image_->second, truth_->truth.hits.surface)});
    }
    write_lit_file(work_, cell(job), pictures);
    store_.put_file(job.key.hex, work_.folder / work_.lit_file(cell(job)));
}

void ViewMaker::make_own_score(const Job& job) {
    const TruthQuery& query = cell(job).own.value();
    const Truth& truth = work_.ranks_by(query) ? truth_->truth : own_truth_->truth;
    own_scores_[job.key] = score_own(truth, query, *ground_, image_->second.visibility);
    keep(job, to_json(own_scores_[job.key]));
}

void ViewMaker::make_repeats(const Job& job) {
    const MethodRequest& request = *cell(job).contestant->timed_request();
    const Repeats& repeats = repeats_[job.key] = repeat_image(
        work_.tools.ready_renderer(), {request, cell(job).converged}, truth_->truth, *ground_, layers_drawn_);
    keep(job, to_json(repeats));
}

// Times the jobs in turns, with the fixed pass among them.
std::vector<std::string> ViewMaker::make_in_turns(std::span<const Job* const> jobs) {
    std::vector<TimedRequest> requests;
    for (const Job* job : jobs) requests.push_back({cell(*job).timed, cell(*job).whole_frames});
    requests.push_back({work_.fixed_pass, false});
    const std::vector<RequestTimes> times =
        time_requests(work_.tools.ready_renderer(), requests, work_.timing_goal, "timing " + work_.key);
    const RequestTimes& fixed_pass = times.back();
    std::vector<std::string> errors;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        errors.push_back(times[i].error);
        if (!errors.back().empty()) continue;
        const RequestTimes& runs = times[i];
        const StoredTimes stored{runs.ao,
                                 runs.filter,
                                 fixed_pass.ao,
                                 fixed_pass.lighting,
                                 runs.frame_at_once,
                                 runs.frame_by_pass,
                                 runs.layers_processor_ms,
                                 runs.gbuffer,
                                 runs.gbuffer_bytes};
        times_[jobs[i]->key] = stored;
        keep(*jobs[i], to_json(stored));
    }
    return errors;
}

}  // namespace aoscore
