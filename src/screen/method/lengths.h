#pragma once

#include "screen/method/method.h"

#include <optional>
#include <string_view>

namespace aoscore {

/// The AO radius, metres, that the lengths of this preset are meant for; empty for a method without lengths.
/// Throws usage_error for an unknown preset.
std::optional<double> reference_radius(const MethodDescriptor& method, std::string_view preset);

/// The preset's values for one AO radius: a value of length power p is multiplied by
/// (radius_m / reference radius)^p, and the parameter that is the radius becomes `radius_m`. An absolute
/// preset keeps its lengths, and `overrides` are taken literally. `radius_m` > 0. Throws usage_error as
/// MethodDescriptor::values() does, also where a length leaves its parameter's range.
ParameterValues values_for_radius(const MethodDescriptor& method, double radius_m, std::string_view preset,
                                  const ParameterValues& overrides = {});

}  // namespace aoscore
