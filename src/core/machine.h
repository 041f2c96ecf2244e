#pragma once

#include <string>

namespace aoscore {

/// The processor's name as the system states it.
std::string cpu_name();
/// The most memory this process ever held, MiB.
double peak_memory_mib();
/// The time now, written as 2026-11-22T02:11:47Z.
std::string utc_now();

}  // namespace aoscore
