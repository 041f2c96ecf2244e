#pragma once

#include "jobs/contest/contestant.h"
#include "jobs/contest/outside_method.h"

#include <cstdint>
#include <memory>
#include <string>

namespace aoscore {

/// What a run asks of an outside command beside the view.
struct CommandRun {
    std::string preset = "default";
    double radius_m = 0;
    std::uint64_t seed = 1;
};

/// Makes a contestant of the image that the outside method's command makes of the view. image() runs it in a
/// temporary folder, and throws where it fails, does not end in its time, or leaves no image that fits.
/// `outside` must outlive it.
std::shared_ptr<const Contestant> command_image(const OutsideMethod& outside, CommandRun run);

}  // namespace aoscore
