#pragma once

#include "core/ratio_table.h"

#include <cstdint>
#include <filesystem>
#include <functional>

namespace aoscore {

/// Makes the page of results that still wait in the folder `staged`, unless the page in `folder`, where they
/// go, shows them already.
using PageWriter =
    std::function<void(const std::filesystem::path& staged, const std::filesystem::path& folder)>;

/// The main job's tables, with truths of 64 rays a pixel: cold, with an empty cache of its own, and again,
/// when everything is there. Leaves in `table` wall-clock seconds of each stage beside the whole run, the
/// warm run beside the cold one, and how the first G-buffer of the atrium compares.
void bench_main(std::uint64_t seed, const PageWriter& write_page, RatioTable& table);

}  // namespace aoscore
