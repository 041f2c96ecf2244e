#pragma once

#include "screen/method/method.h"

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// A rule for the depths that a texel keeps of all that are drawn over it: a row of the one table.
struct DepthSampling {
    std::string_view id;     ///< its name in descriptors
    std::string_view macro;  ///< its macro in shaders/gbuffer/depth_layers.frag; empty: no pass draws it
    std::string_view meaning;
    bool tosses_coins = false;  ///< which surfaces a sample keeps is drawn at random, with alpha
    /// It depends on pixel and triangle alone, so that layers can be gathered from surfaces that were kept
    /// (screen/gbuffer/surface_layer.h).
    bool of_kept_surfaces = false;
};
const std::vector<DepthSampling>& depth_samplings();

/// Whether layers of this sampling are drawn by passes over the scene, or met by rays.
bool is_rasterised(std::string_view sampling);

/// Several depths a texel for a method: a stochastic-depth buffer (Vermeer, Stochastic-Depth Ambient
/// Occlusion, 2020, chapter 5 and section 6.1; after Enderton et al., Stochastic Transparency, 2010), or
/// layers that were peeled off (Everitt, Interactive Order-Independent Transparency, 2001), met by rays
/// (Brüll, Kern and Grosch, Ray Traced Stochastic Depth Map for Ambient Occlusion, 2024), or drawn of what
/// stands still and of what moves (Tatarinov and Panteleev, Advanced Ambient Occlusion Methods for Modern
/// Games, 2016, as Vermeer tells it in chapter 3).
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
    /// Peeled layers alone: the depth of a surface that is seen from behind its front face is negative.
    bool facing = false;
    /// Layers by rays alone: those behind the first lie at most so far behind it, metres; 0: anywhere.
    double reach_m = 0;

    auto operator<=>(const DepthLayers&) const = default;
};

/// The members of a descriptor's "depth_layers" with the values that they accept.
const std::vector<Parameter>& depth_layers_members();

/// The depth layers for these parameters, in a run of this seed. The input may have further members.
DepthLayers asked_depth_layers(const InputMembers& input, const ParameterValues& parameters,
                               std::uint64_t run_seed);

/// The floats that a texel of so many depths takes: they lie in textures of one, two or four each.
int stored_depths(int samples);

/// Whether the method, with these parameters, reads layers that rays meet.
bool reads_ray_layers(const MethodDescriptor& method, const ParameterValues& parameters);

/// Changes of a method's parameters by which each texel of "depth_layers" holds the first layer alone, or all
/// layers from front to back, kMost at most, and no side camera adds any. Empty for a method without the
/// input, and where its descriptor fixes a member that would have to change.
std::optional<ParameterValues> first_layer_alone(const MethodDescriptor& method);
std::optional<ParameterValues> all_layers(const MethodDescriptor& method);

}  // namespace aoscore
