#pragma once

#include "jobs/contest/contestant.h"
#include "jobs/contest/outside_method.h"

#include <memory>
#include <string>

namespace aoscore {

/// Makes a contestant of the outside method's image of the view. image() reads it, and throws where it is
/// missing, has another size or cannot be read. `outside` must outlive it.
std::shared_ptr<const Contestant> folder_image(const OutsideMethod& outside, const std::string& view);

}  // namespace aoscore
