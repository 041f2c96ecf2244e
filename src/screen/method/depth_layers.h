#pragma once

#include "screen/method/method.h"

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

class StrictObject;

/// A rule for the depths that a texel keeps of all that are drawn over it: a row of the one table.
struct DepthSampling {
    std::string_view id;     ///< its name in descriptors
    std::string_view macro;  ///< its macro in shaders/gbuffer/depth_layers.frag
    std::string_view meaning;
};
const std::vector<DepthSampling>& depth_samplings();

/// Several depths a texel for a method: a stochastic-depth buffer (Vermeer, Stochastic-Depth Ambient
/// Occlusion, 2020, chapter 5 and section 6.1; after Enderton et al., Stochastic Transparency, 2010), or
/// layers that were peeled off (Everitt, Interactive Order-Independent Transparency, 2001).
struct DepthLayers {
    static constexpr int kMost = 16;
    int samples = 1;   ///< depths a texel, 1 to kMost
    double alpha = 1;  ///< probability that a sample keeps a surface; no effect on peeled layers
    std::string sampling = "stratified";  ///< a row of depth_samplings()
    bool per_sample = true;               ///< false: a surface's samples share one coin
    std::uint32_t seed = 1;
    /// Peeled layers alone: a layer lies at least so far behind the one in front of it, metres (Mara,
    /// McGuire, Nowrouzezahrai and Luebke, Deep G-Buffers for Stable Global Illumination Approximation,
    /// 2016).
    double least_gap_m = 0;

    auto operator<=>(const DepthLayers&) const = default;
};

/// Reads a descriptor's "depth_layers". Throws file_error for a value that a member does not accept, and for
/// a parameter that may have such a value.
DepthLayersDescriptor parse_depth_layers(const MethodDescriptor& method, StrictObject object);

/// Whether some member names this parameter.
bool names_parameter(const DepthLayersDescriptor& descriptor, std::string_view parameter);

/// The depth layers for these parameters, in a run of this seed.
DepthLayers asked_depth_layers(const DepthLayersDescriptor& descriptor, const ParameterValues& parameters,
                               std::uint64_t run_seed);

/// Changes of a method's parameters by which each texel holds the first layer alone, or all layers from front
/// to back, kMost at most. Empty where the descriptor fixes a member that would have to change.
std::optional<ParameterValues> first_layer_alone(const DepthLayersDescriptor& descriptor);
std::optional<ParameterValues> all_layers(const DepthLayersDescriptor& descriptor);

}  // namespace aoscore
