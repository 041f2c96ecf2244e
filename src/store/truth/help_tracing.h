#pragma once

#include "store/truth/tracing_help.h"
#include "store/truth/truth_request.h"

#include <functional>

namespace aoscore {

class CacheFile;

/// Traces and publishes chunks of a truth that another process traces, from the last on, which comes last
/// there, until all have begun or `ended` is true, which is asked before every chunk. `base` has tiles with
/// fewer rays, or is null. Throws file_error where nothing can be published, interrupted_error on Ctrl-C.
void help_tracing(const TracingHelp& help, const ReferenceScene& reference, const TruthRequest& request,
                  const CacheFile* base, const std::function<bool()>& ended);

}  // namespace aoscore
