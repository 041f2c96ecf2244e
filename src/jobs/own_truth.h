#pragma once

#include "reference/truth.h"
#include "screen/method/method.h"

#include <string>
#include <vector>

namespace aoscore {

/// The truth that a method with these parameters claims to approximate: its own falloff at its own radius.
/// Throws file_error where the descriptor names a falloff or parameter that does not exist.
TruthQuery own_truth(const MethodDescriptor& method, const ParameterValues& parameters);

/// A short name for a query: "binary-0.5", "quadratic-2", "alchemy-u0.128".
std::string truth_id(const TruthQuery& query);

std::string falloff_name(Falloff falloff);

}  // namespace aoscore
