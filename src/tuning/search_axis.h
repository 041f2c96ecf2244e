#pragma once

#include "screen/method/method.h"

#include <string>
#include <vector>

namespace aoscore {

/// A parameter that is tuned. A search sees its values as positions in [0,1]. A length is tuned as it stands
/// for the AO radius that its preset is meant for, and scaled to the radius of each view.
struct SearchAxis {
    std::string parameter;
    bool whole = false;        ///< integers alone
    bool logarithmic = false;  ///< even steps of the position are even factors of the value
    double low = 0, high = 1;  ///< limits of the value at the reference radius
    bool more_below = false, more_above = false;  ///< whether the parameter's range goes on beyond them
    double published = 0;                         ///< the preset's value there
    int length_power = 0;
    double reference_radius_m = 1;

    /// The value at the reference radius for a position.
    double value(double position) const;
    double position(double value) const;
    /// Whether the value lies at a limit of the search beyond which the parameter's range goes on.
    bool ends_search(double value) const;
    /// The value on a view of this AO radius.
    ParameterValue on_view(double value, double radius_m) const;
};

/// The parameters to tune: those of `wanted`, or, where it is empty, the real numbers that affect visibility,
/// and with `counts` the integers, too. The radius of a method is not among them: it is the question. Limits
/// are a quarter and four times of a preset's value, within its range; for a preset's 0 the range, or a
/// quarter of the radius for a length. Throws usage_error for a parameter that does not exist, cannot be
/// tuned, or where none is left.
std::vector<SearchAxis> search_axes(const MethodDescriptor& method, const std::string& preset,
                                    const std::vector<std::string>& wanted, bool counts);

}  // namespace aoscore
