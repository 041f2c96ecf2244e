#pragma once

#include <string>

namespace aoscore {

/// The processor's name as the system states it.
std::string cpu_name();
/// Whether this GL_RENDERER draws on the processor, so that its milliseconds say nothing of a GPU's.
bool is_software_renderer(const std::string& gl_renderer);
/// The most memory this process ever held, MiB.
double peak_memory_mib();
/// The time now, written as 2026-11-22T02:11:47Z.
std::string utc_now();

}  // namespace aoscore
