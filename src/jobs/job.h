#pragma once

#include "store/key.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// The kinds of artifacts, each made by a job of its own.
enum class ArtifactKind : std::uint8_t {
    gbuffer_times,  ///< runs of the G-buffer alone, milliseconds
    gbuffer,        ///< the channels that methods read
    truth,          ///< visibility with its standard error
    own_truth,      ///< the truth for methods' own radii and falloffs
    contract,       ///< the pixels that both paths see alike, with facts about each
    view,           ///< the record of truth and contract in the results
    truth_file,
    gbuffer_file,
    image,           ///< a method's visibility, and its file where that is kept
    score,           ///< metrics and analysis against the ranking's truth
    own_score,       ///< metrics against the method's own truth
    fetches,         ///< texture fetches a pixel
    times,           ///< runs of the method's passes, milliseconds
    unstressed,      ///< pictures of a stress test's subjects without stress
    stress_setting,  ///< facts of a stressed view, whatever subject runs on it
    stress_cell,     ///< one subject on a stressed view
    irradiance,      ///< ray-traced under an environment, in a file
    view_light,      ///< the record of the irradiance in the results
    light,           ///< errors of a method's light against it
    lit_file,        ///< a method's lit pictures
    repeats,         ///< what other seeds and other depth layers show of a method's image
};
inline constexpr std::size_t kArtifactKinds = 21;
/// Their names in lists of jobs, in the order of ArtifactKind.
inline constexpr std::array<std::string_view, kArtifactKinds> kArtifactKindIds{
    "gbuffer_times",  "gbuffer",     "truth",      "own_truth",  "contract", "view",     "truth_file",
    "gbuffer_file",   "image",       "score",      "own_score",  "fetches",  "times",    "unstressed",
    "stress_setting", "stress_cell", "irradiance", "view_light", "light",    "lit_file", "repeats"};
constexpr std::string_view id_of(ArtifactKind kind) {
    return kArtifactKindIds[static_cast<std::size_t>(kind)];
}
/// Whether it holds times alone, without which the others are whole.
constexpr bool is_of_times(ArtifactKind kind) {
    return kind == ArtifactKind::times || kind == ArtifactKind::gbuffer_times;
}

/// Makes one artifact, which is a function of its inputs and of the parts of its key, and of nothing else.
struct Job {
    Key key;  ///< the artifact's key
    ArtifactKind kind = ArtifactKind::image;
    std::string about;        ///< "atrium/wide/hbao/default"
    std::vector<Key> inputs;  ///< artifacts that must be at hand when it is made
    /// Jobs whose failure makes this one pointless; its artifact does not depend on them.
    std::vector<Key> after;
    std::size_t cell = 0;   ///< index of the cell in the view's work, for a cell's job
    bool in_turns = false;  ///< made together with others of its kind, so that all meet the same disturbances
    bool essential = false;  ///< without it nothing else can be made
};

/// The jobs of a plan by key, each once, with the list of those that are asked for.
class JobGraph {
  public:
    /// Adds a job that others may need. The same job twice counts once.
    const Job& add(Job job);
    /// The same, and its artifact is asked for.
    const Job& want(Job job);

    const Job& at(const Key& key) const { return jobs_[index_.at(key)]; }
    bool contains(const Key& key) const { return index_.contains(key); }
    /// In the order they were added.
    std::span<const Job> jobs() const { return jobs_; }
    std::span<const Key> wanted() const { return wanted_; }

  private:
    std::vector<Job> jobs_;
    std::map<Key, std::size_t> index_;
    std::vector<Key> wanted_;
};

}  // namespace aoscore
