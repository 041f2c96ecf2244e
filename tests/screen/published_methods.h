#pragma once

#include "published_picture.h"

namespace aoscore::testing::published {

/// The visibility that an implementation gives a pixel, before any filter. Lengths are in metres; other
/// settings are the implementation's defaults.
using Estimator = std::function<double(int x, int y)>;

/// N8AO 2.1 without its power, with 16 samples.
Estimator n8ao(const Picture& picture, const Noise& noise, double radius, bool normals_from_depth);
/// XeGTAO 1.30, which may exceed 1.
Estimator xegtao(const Picture& picture, const Noise& noise, double radius, int slices, int steps);
/// three.js' GTAOPass 0.187.
Estimator three_gtao(const Picture& picture, double radius, double thickness);
/// NVIDIA's HBAO+ without its power.
Estimator hbao_plus(const Picture& picture, const Noise& noise, double radius);
/// Ports of ASSAO: CACAO at quality high, Godot's at its default quality. Inputs are the pattern's places in
/// the unit disc, and the tangent of half the angle of view.
Estimator cacao(const Picture& picture, const std::vector<glm::dvec2>& pattern, double radius,
                double tan_half);
Estimator godot_ssao(const Picture& picture, const std::vector<glm::dvec2>& pattern, double radius,
                     double tan_half);
/// SAO's reference implementation with 11 samples.
Estimator sao(const Picture& picture, double radius);
/// Filament's SSAO at quality low, at full resolution.
Estimator filament_ssao(const Picture& picture, double radius);
/// SSRT3's occlusion of one frame, with the noise's first number in place of its sine.
Estimator visibility_bitmask(const Picture& picture, const Noise& noise, double radius, double thickness);

/// De Vries' LearnOpenGL.
Estimator learnopengl_ssao(const Picture& picture, const Kernel3& kernel, const Noise& noise, double radius);
/// Hussain's programs of Crytek's and Alchemy's AO.
Estimator hussain_crytek(const Picture& picture, const Kernel3& kernel, const Noise& noise, double radius);
Estimator hussain_alchemy(const Picture& picture, const Kernel3& disc, const Noise& noise, double radius);
/// Whinham's hemisphere.
Estimator whinham_ssao(const Picture& picture, const Kernel3& kernel, const Noise& noise, double radius);
/// Gravås' Alchemy AO on a spiral of 9 taps.
Estimator gravas_spiral(const Picture& picture, double radius);
/// Vermeer's algorithms 1, 2 and 3, or 9, 7 and 8 where the picture was given layers; 4 directions of 4
/// steps. Surfaces whose cosine to the normal is not above the least one are left out, as in algorithm 7.
Estimator vermeer_ssao(const Picture& picture, const Kernel3& kernel, const Noise& noise, double radius);
Estimator vermeer_hbao(const Picture& picture, const Noise& noise, double radius, double least_cosine = -2);
Estimator vermeer_hbao_plus(const Picture& picture, const Noise& noise, double radius);
/// HBAO of NVIDIA's Direct3D SDK 11.
Estimator nvidia_hbao(const Picture& picture, const Noise& noise, double radius);
/// Unity's SSAO, with white noise in place of its blue noise, or with its interleaved gradient noise.
Estimator unity_ssao(const Picture& picture, const Numbers& numbers, std::uint64_t seed, double radius);
Estimator unity_gradient_ssao(const Picture& picture, const Numbers& numbers, double radius);

/// The implementations' own filters with their powers, applied to an image of visibility.
ImageF xegtao_denoised(const Picture& picture, const ImageF& visibility);
ImageF n8ao_denoised(const Picture& picture, const Noise& noise, const ImageF& visibility, double radius);
ImageF three_denoised(const Picture& picture, const Noise& noise, const ImageF& visibility, double depth_phi);
ImageF hbao_plus_blurred(const Picture& picture, const ImageF& visibility);
ImageF cacao_blurred(const Picture& picture, const ImageF& visibility);
ImageF filament_blurred(const Picture& picture, const ImageF& visibility);
ImageF nvidia_hbao_blurred(const Picture& picture, const ImageF& visibility);
ImageF unity_blurred(const Picture& picture, const ImageF& visibility);
ImageF box_blurred(const Picture& picture, const ImageF& visibility);
ImageF sao_blurred(const Picture& picture, const ImageF& visibility);

}  // namespace aoscore::testing::published
