#include "stress/stress_maker.h"

#include "core/error.h"
#include "core/log.h"
#include "stress/stress_thumbnails.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace aoscore {
namespace {

std::size_t count_of(const Mask& mask) {
    return static_cast<std::size_t>(std::ranges::count(mask.pixels, 1));
}

}  // namespace

StressMaker::StressMaker(const StressWork& work, const ArtifactStore& store, Unstressed& unstressed)
    : work_(work), store_(store), unstressed_(unstressed), sources_(work.view, {}, store, described_) {}

const StressedCell* StressMaker::cell(const Key& key) const {
    const auto found = cells_.find(key);
    return found == cells_.end() ? nullptr : &found->second;
}

std::optional<double> StressMaker::time_ms(const Key& key) const {
    const auto found = times_.find(key);
    return found == times_.end() ? std::nullopt : std::optional(found->second);
}

// Takes an artifact from the store; a damaged or foreign entry counts as missing.
bool StressMaker::take(const Job& job) {
    try {
        if (job.kind == ArtifactKind::stress_setting) {
            const std::optional<nlohmann::json> kept = store_.find(job.key.hex);
            if (kept) setting_ = stress_setting_from_json(*kept, job.key.hex);
            return kept.has_value();
        }
        if (is_of_times(job.kind)) {
            const std::optional<nlohmann::json> kept = store_.find(job.key.hex);
            if (!kept) return false;
            if (!kept->is_number()) throw file_error("is no number", job.key.hex);
            times_[job.key] = kept->get<double>();
            return true;
        }
        if (job.kind != ArtifactKind::stress_cell) return sources_.take(job);
        const std::optional<std::filesystem::path> kept = store_.file(job.key.hex);
        if (kept) cells_[job.key] = read_stressed_cell(*kept);
        return kept.has_value();
    } catch (const Error& e) {
        log_warning(std::string(e.what()) + "; run again");
        return false;
    }
}

bool StressMaker::take_input(const Job& job) {
    return job.kind == ArtifactKind::unstressed ? unstressed_.made() : sources_.take_input(job);
}

void StressMaker::make(const Job& job) {
    switch (job.kind) {
        case ArtifactKind::unstressed:
            return unstressed_.make(store_);
        case ArtifactKind::stress_setting:
            return make_setting(job);
        case ArtifactKind::stress_cell:
            return make_cell(job);
        case ArtifactKind::times:
        case ArtifactKind::gbuffer_times:
            return make_times(job);
        default:
            work_.view.tools.choose(work_.stress.scene);
            sources_.make(job);
    }
}

std::vector<std::string> StressMaker::make_in_turns(std::span<const Job* const> jobs) {
    throw internal_error("nothing is made in turns", jobs.front()->about);
}

void StressMaker::make_setting(const Job& job) {
    StressSettingRecord& setting = setting_.emplace();
    if (work_.stress.has_truth) {
        const CameraContract& contract = sources_.ground()->contract;
        setting.surface_pixels = contract.surface;
        setting.compared_pixels = contract.valid_count;
        setting.disagreeing_share = contract.disagreeing_share();
        setting.truth_samples = work_.view.truth.samples;
        setting.truth_seconds = sources_.truth()->seconds;
    } else {
        setting.surface_pixels = setting.compared_pixels = count_of(sources_.gbuffer()->surface);
    }
    store_.put(job.key.hex, to_json(setting));
}

void StressMaker::make_times(const Job& job) {
    const double ms =
        job.kind == ArtifactKind::gbuffer_times ? sources_.drawn_ms() : timed_ms(work_.requests[job.cell]);
    times_[job.key] = ms;
    store_.put(job.key.hex, ms);
}

double StressMaker::timed_ms(const StressRequest& request) {
    const MethodRequest* timed = request.contestant->timed_request();
    if (timed == nullptr) return 1000 * sources_.truth()->seconds;
    const ScreenRenderer::PassTimes times = work_.view.tools.ready_renderer().time(*timed);
    return times.filter ? times.filter->ms : times.ao.ms;
}

void StressMaker::make_cell(const Job& job) {
    const StressRequest& request = work_.requests[job.cell];
    StressedCell made;
    StressCell& cell = made.cell;
    cell.subject = request.subject->id;
    const StressedPicture picture = stressed_picture(work_, request, sources_);
    count_faults(picture, cell);
    ImageF difference;
    compare_with_unstressed(work_.judgement, picture, unstressed_.of(request), cell, difference);
    judge(work_.judgement, cell);
    const double disagreeing =
        sources_.ground() != nullptr ? sources_.ground()->contract.disagreeing_share() : 0;
    if (request.subject->kind == "reference" && cell.breaks.empty() &&
        disagreeing > CameraContract::kTolerated) {
        cell.breaks = fmt::format("sees other surfaces than the rasteriser on {:.1f} % of the pixels",
                                  100 * disagreeing);
    }
    made.picture = stress_thumbnail(picture.visibility, kPictureSteps);
    if (!difference.empty()) made.difference = stress_thumbnail(difference, kDifferenceSteps);
    const std::filesystem::path file = folder_.path() / "cell.exr";
    write_stressed_cell(file, made);
    store_.put_file(job.key.hex, file);
    cells_[job.key] = std::move(made);
}

}  // namespace aoscore
