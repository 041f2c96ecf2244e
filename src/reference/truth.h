#pragma once

#include "core/image.h"
#include "reference/ray_layers.h"
#include "scene/scene.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// How much a hit at distance t darkens, g(t) in [0,1]; visibility is the mean of 1 - g over cosine-weighted
/// rays.
enum class Falloff {
    binary,     ///< 1 within the radius (ambient occlusion proper)
    quadratic,  ///< 1 - (t/R)^2 within R (Bavoil, Sainz, Image-Space Horizon-Based Ambient Occlusion, 2008)
    xegtao,     ///< 1, falling linearly to 0 over the last 61.5 % of R (Intel, XeGTAO, 2021)
    alchemy,    ///< u t / max(u, t)^2, never 0 (McGuire et al., The Alchemy Screen-Space Ambient Obscurance
                ///< Algorithm, 2011)
};

inline constexpr std::size_t kFalloffs = 4;
/// Their names in files, results and method descriptors, in the order of Falloff.
inline constexpr std::array<std::string_view, kFalloffs> kFalloffIds{"binary", "quadratic", "xegtao",
                                                                     "alchemy"};

/// One truth to be read from a set of rays.
struct TruthQuery {
    Falloff falloff = Falloff::binary;
    double radius_m = 1.0;  ///< > 0, infinity allowed; hits beyond it count nothing, whatever the falloff
    double u_m = 0;         ///< alchemy only: its u, metres, > 0
    bool operator==(const TruthQuery&) const = default;
};

/// Why a camera's single depth layer may miss an occluder, by where the nearest hit of a ray lies. Tested in
/// this order; the first three are what the layer does not show (Vermeer, 2020, names them), the last is a
/// method's own loss.
enum class Cause : std::uint8_t {
    outside,  ///< not within the picture, or not between the near and far plane
    hidden,   ///< behind what the pixel shows there, by more than 1 % of its depth and more than a pixel's
              ///< footprint
    grazing,  ///< seen so flat, |n v| < 0.1, that it has hardly a pixel
    visible,
};
inline constexpr std::size_t kCauses = 4;
/// Their names in files and results, in the order of Cause.
inline constexpr std::array<std::string_view, kCauses> kCauseIds{"outside", "hidden", "grazing", "visible"};

/// Further sums to gather from the rays, for the first query.
struct TruthExtras {
    bool causes = false;
    /// Occlusion by rays that meet any visible surface within the radius, be it behind a hidden one: no
    /// method that knows one depth layer can find more. Costs further rays.
    bool one_layer_bound = false;
    /// Bent normals, with directions weighted alike: they cost a second set of rays, as many as the first and
    /// uniform over the hemisphere, since cosine-distributed ones weighted by 1 / (2 cos) vary without bound.
    bool bent_normals = false;
    TruthExtras& operator|=(const TruthExtras& other) {
        causes |= other.causes;
        one_layer_bound |= other.one_layer_bound;
        bent_normals |= other.bent_normals;
        return *this;
    }
    bool any() const { return of_hits() || bent_normals; }
    /// Whether where rays hit must be known.
    bool of_hits() const { return causes || one_layer_bound; }
    bool operator==(const TruthExtras&) const = default;
};

/// Where directions come from.
enum class PointKind : std::uint8_t {
    scrambled_sobol,  ///< Owen-scrambled Sobol sequence: the error falls almost as N^-3/4
    independent,      ///< plain Monte Carlo, N^-1/2: only to measure what the others are worth
};

struct TruthSettings {
    int samples = 64;  ///< rays a pixel, >= 1; the least of them where max_error is set
    /// 0: `samples` rays everywhere. Else every pixel gets more of them until the standard error of each
    /// query is at most this, beginning with no fewer than 2 / max_error rays, so that an occluder that
    /// matters at this error is not missed by a lucky start, and ending with kMostSamples.
    double max_error = 0;
    /// 0: off. Else every pixel gets the same number of rays, `samples` or more, such that the mean standard
    /// error over the picture comes to about this, be it the one query's or that of the query that errs most:
    /// the picture that so many `samples` have. Not together with max_error.
    double mean_error = 0;
    /// The rays of a pixel are two independent sequences of samples / 2 each, as TruthCache traces them: what
    /// the truth's noise does to any number that is made of the picture then follows from the two halves,
    /// without bias, see Truth::halves. An even count; not together with an error.
    bool halves = false;
    std::uint64_t seed = 1;
    bool shading_normals = false;  ///< hemisphere about the smooth normal instead of the geometric one
    PointKind points = PointKind::scrambled_sobol;
    TruthExtras extras;
    /// Pixels with nothing above their tangent plane within reach are proven open instead of traced.
    bool skip_open = true;
    /// Rays that reach far ask the scene's largest triangles before all others: the same bits, sooner.
    bool large_triangles_first = true;
};

/// The rays of a pixel are summed in no more than this many consecutive blocks, see block_size().
inline constexpr int kBlocks = 8;

/// Rays in each block of the first `samples` rays of a pixel (the last block may have fewer): the least power
/// of two that leaves no more than kBlocks of them.
constexpr int block_size(int samples) {
    int size = 1;
    while (size * kBlocks < samples) size *= 2;
    return size;
}

/// The standard error of a pixel that is proven open: float32's rounding of 1.
inline constexpr float kProvenError = 0x1p-24f;

/// No pixel gets more rays than this, whatever its error.
inline constexpr int kMostSamples = 1 << 20;
/// A truth that takes longer is refused before it is traced.
inline constexpr double kLongestTrace_s = 86400;

/// The surface at each pixel centre: the same quantities as the rasterised G-buffer, for the camera contract.
struct PrimaryHits {
    Mask surface;             ///< 1 where a surface lies between the near and far plane
    ImageF depth;             ///< view depth -z, metres; 0 without surface
    Image<glm::vec3> normal;  ///< geometric, view space, unit, turned to the camera; 0 without surface
};

/// Ray-traced visibility of every pixel, and how sure of it we are.
///
/// The rays of a pixel are one scrambled sequence, as independent scrambles of fewer points each would err
/// more. The standard error comes from how far the means of its blocks lie apart, and how that shrinks as
/// blocks grow, moderated by what the surrounding tile shows (see moderated_estimates()). From 16 rays on it
/// holds in the tail, fewer than 1 pixel in 200 errs by more than three times of it, and its root mean square
/// is that of the true errors within 6 % over six scenes and 20 % on each. Where all rays of a pixel agree
/// the spread says nothing, and how many of its neighbours agree as well takes its place (see
/// error_of_agreement()); a single sample has the spread of its tile.
struct Truth {
    PrimaryHits hits;
    std::vector<TruthQuery> queries;
    std::vector<ImageF> visibility;      ///< one image a query, in [0,1]; 1 where there is no surface
    std::vector<ImageF> standard_error;  ///< one image a query, > 0 on surfaces; 0 where there is none
    /// Where the rays are two independent sequences, the visibility by each of them, a pair a query; the mean
    /// of the two is `visibility`. Half their difference squared is an unbiased estimate of a pixel's
    /// variance, however few the rays, since neither half knows of the other. Else empty.
    std::vector<std::array<ImageF, 2>> halves;
    /// Occlusion of the first query, 1 - visibility, by Cause: four images that add up to it; empty unless
    /// asked for.
    std::array<ImageF, kCauses> occlusion_by_cause;
    ImageF one_layer_bound;  ///< occlusion in [0,1]; empty unless asked for
    /// Mean of the open directions of the first query, n', all directions of the hemisphere weighted alike,
    /// view space: 1/2 long where all is open, longer where less is, 1 at most (Vermeer, Stochastic-Depth
    /// Ambient Occlusion, 2020, section 7.1). The normal itself where no ray was open; 0 without surface;
    /// empty unless asked for, like the three that follow.
    Image<glm::vec3> bent_normal;
    ImageF bent_error_rad;  ///< standard error of its direction, as an angle; pi/2 where it is not known
    /// Half angle of the cone about it that is as open: pi/2 (1 - max(2 |n'| - 1, 0)).
    ImageF cone_angle_rad;
    ImageF cone_error_rad;               ///< standard error of the cone's half angle
    Image<std::uint32_t> sample_counts;  ///< rays of each pixel; 0 where none were needed
    int samples = 0;                     ///< rays a pixel with a surface (the mean, rounded, if they differ)
    std::uint64_t rays = 0;  ///< that all pixels got together; those for bent normals are as many again
    std::uint64_t rays_now =
        0;  ///< traced in this very call, by a search for a mean error too; those for bent normals left out
    std::uint64_t open_pixels = 0;  ///< proven open without a ray
    /// Over instances: out of reach of all that the camera sees, so that they were not built for tracing; 0
    /// where nothing was built for it.
    std::uint64_t left_out_triangles = 0;
    double seconds = 0;  ///< tracing only, that of kept tiles included
};

/// The ray tracer and its version: "Embree 3.13.5".
std::string tracer_version();

class TileStore;
struct GroupState;

/// Throws usage_error for queries or settings out of range.
void check_truth_request(const std::vector<TruthQuery>& queries, const TruthSettings& settings);

/// The truth whose tiles a store has, of those queries whose numbers are in `which`: no ray is traced.
/// `queries` and `settings` are what the tiles were traced for; extras are taken as far as `extras` says.
Truth kept_truth(const CameraFrame& frame, const std::vector<TruthQuery>& queries,
                 const TruthSettings& settings, const std::vector<std::size_t>& which,
                 const TruthExtras& extras, const TileStore& store);

/// How a scene is laid out for tracing; the picture does not depend on it beyond rounding.
struct TraceBuild {
    /// Meshes used more than once are copied into scene space (faster to trace) while the scene has no more
    /// triangles than this; beyond it they stay instances (smaller).
    std::size_t baked_triangles_at_most = 2'000'000;
    /// Where a scene is built when needed, instances that no ray of a picture can meet are left out: the same
    /// bits, sooner.
    bool leave_out_of_reach = true;
};

/// A scene built for Embree; serves any number of views, in any number of threads.
class ReferenceScene {
  public:
    /// Builds all of `scene` at once, and keeps what it needs of it.
    explicit ReferenceScene(const Scene& scene, const TraceBuild& build = {});
    /// Builds when rays are wanted, which is never where a cache has all, and for each picture no more than
    /// its rays can meet; `scene` must live as long as this is used.
    static ReferenceScene built_when_needed(const Scene& scene, const TraceBuild& build = {});
    ~ReferenceScene();
    ReferenceScene(ReferenceScene&&) noexcept;
    ReferenceScene& operator=(ReferenceScene&&) noexcept;

    /// The most memory Embree has held for what is built of this scene, bytes; 0 before anything is.
    std::size_t peak_bytes() const;
    /// As it was laid out.
    const TraceBuild& build() const;

    PrimaryHits primary_hits(const CameraFrame& frame) const;

    /// Several depths of each pixel, by rays through the pixels' centres: a picture of view depth in metres
    /// for each sample, the far plane's where it is empty, row 0 at the top. The same for any thread count.
    std::vector<ImageF> ray_layers(const CameraFrame& frame, const RayLayers& wanted) const;

    /// Integrates all queries from the same rays. The same image for any thread count. `what` names the work
    /// for its progress bar. With a store, tiles that it has are taken from there and all others are put
    /// there. Throws interrupted_error on Ctrl-C, usage_error for settings out of range.
    Truth trace(const CameraFrame& frame, const std::vector<TruthQuery>& queries,
                const TruthSettings& settings, const std::string& what, TileStore* store = nullptr) const;

    /// Traces groups (see TileGroups), those that `next` gives until it gives none, from what the store has
    /// begun of them, and keeps them there.
    void trace_into(TileStore& store, const CameraFrame& frame, const std::vector<TruthQuery>& queries,
                    const TruthSettings& settings,
                    const std::function<std::vector<std::size_t>()>& next) const;

    /// All that is known of the tiles of these groups, traced without a store.
    std::vector<GroupState> trace_groups(const CameraFrame& frame, const std::vector<TruthQuery>& queries,
                                         const TruthSettings& settings,
                                         const std::vector<std::size_t>& numbers) const;

  private:
    struct Impl;
    explicit ReferenceScene(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace aoscore
