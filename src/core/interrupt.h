#pragma once

namespace aoscore {

/// From here on Ctrl-C (SIGINT) and SIGTERM only raise a flag. The process ends at once with another one a
/// second later or more, and ten seconds after the first, whatever is under way then.
void catch_interrupts();

/// True once Ctrl-C was pressed. Cheap; callable from any thread.
bool interrupt_requested();

/// Throws interrupted_error() once Ctrl-C was pressed. Call between tiles, passes and files, never inside
/// a parallel loop's body that must not throw.
void throw_if_interrupted();

}  // namespace aoscore
