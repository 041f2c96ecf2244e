#pragma once

#include "image/image_file.h"
#include "jobs/contest/contestant.h"
#include "jobs/ground.h"
#include "jobs/view_work.h"
#include "reference/irradiance.h"
#include "results/light_modes.h"
#include "store/truth/truth_cache.h"

#include <span>

namespace aoscore {

// These functions write the image files of a view, below its work's folder.

void write_truth_file(const ViewWork& work, const CachedTruth& traced, const Ground& ground);
void write_gbuffer_file(const ViewWork& work, const GBufferImages& gbuffer,
                        std::span<const SurfaceLayer> surfaces);
/// Writes the output as `Y`, the image before the filter, where there is one, as `raw.Y`, and the channels of
/// its signals (see core/signal.h); its header keeps the cost that was reported.
void write_image_file(const ViewWork& work, const CellWork& cell, const ContestantImage& image);
/// Writes the irradiance over pi as `R`, `G`, `B`, and half of what its first estimate exceeds its second by
/// as `half_difference.R`, ….
void write_irradiance_file(const ViewWork& work, const Irradiance& irradiance);
/// What write_irradiance_file() has written; empty where a channel is missing.
std::optional<Irradiance> irradiance_of(const ImageFile& file);
/// A picture that a cell is lit to, by the mode.
struct LitPicture {
    LightMode mode;
    Image<glm::vec3> irradiance;  ///< over pi
};
/// Writes the pictures as LightMode::channels().
void write_lit_file(const ViewWork& work, const CellWork& cell, std::span<const LitPicture> pictures);
/// The cost that write_image_file() has kept in a file.
std::optional<ReportedCost> reported_cost(const ImageFile& file);

}  // namespace aoscore
