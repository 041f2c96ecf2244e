#pragma once

#include "core/image.h"
#include "scene/camera.h"
#include "screen/method/kernel.h"
#include "screen/screen.h"

#include <glm/glm.hpp>

#include <functional>
#include <utility>
#include <vector>

/// Published implementations, evaluated in double precision on a G-buffer that a scene's view has drawn: from
/// their mathematics and constants, sharing nothing with the shaders but that G-buffer.
namespace aoscore::testing::published {

/// A G-buffer in perspective. Places are pixels from the top left corner, y downwards; view space has y up
/// and looks down -z.
class Picture {
  public:
    Picture(const CameraFrame& frame, const GBufferImages& images);

    int width() const { return depth_.width; }
    int height() const { return depth_.height; }
    double near() const { return near_; }
    double far() const { return far_; }

    /// The depth of a texel, or of the nearest one in the picture.
    double depth(int x, int y) const;
    bool surface(int x, int y) const;
    /// All depths of the texel by take_layers(), else its depth alone.
    std::vector<double> depths(int x, int y) const;
    void take_layers(std::vector<ImageF> layers) { layers_ = std::move(layers); }
    glm::dvec3 normal(int x, int y) const;
    glm::dvec3 smooth_normal(int x, int y) const;

    /// The point on the line of sight through a place.
    glm::dvec3 point(double x, double y, double depth) const;
    glm::dvec3 point(int x, int y) const { return point(x + 0.5, y + 0.5, depth(x, y)); }
    glm::dvec2 place(const glm::dvec3& point) const;
    double pixels_per_metre(double depth) const { return height() / (2 * tan_y_ * depth); }

    /// The normal by differences of position to the right and below, or to the left and above at the
    /// picture's edge; it faces the camera.
    glm::dvec3 face_normal(int x, int y) const;

    /// The normal from the depths around, extrapolated from the better side (Wu, Accurate Normal
    /// Reconstruction from Depth Buffer, 2019); it faces the camera.
    glm::dvec3 normal_from_depth(int x, int y) const;

  private:
    Mask surface_;
    ImageF depth_;
    std::vector<ImageF> layers_;
    Image<glm::vec3> normal_, smooth_;
    double near_, far_, tan_x_, tan_y_;
};

/// Levels of depth, each half the size of the one before; `reduce` makes a texel (x, y) of the four of the
/// finer level at (2x, 2y), row by row.
class DepthLevels {
  public:
    using Reduce = std::function<double(const double (&four)[4], int x, int y)>;
    DepthLevels(const Picture& picture, const Reduce& reduce);
    /// The depth of the level's texel that covers a full texel, or of the nearest one in the picture.
    double depth(int level, int x, int y) const;

  private:
    std::vector<ImageF> levels_;
};

/// Picks one of the four in turn (McGuire, Mara and Luebke, Scalable Ambient Obscurance, 2012).
double rotated_pick(const double (&four)[4], int x, int y);
/// The mean of those within `reach` of the farthest, of which the nearest count less (Intel, XeGTAO, 2021).
double farthest_mean(const double (&four)[4], double reach);

/// The value of an image's pixel, or of the nearest one in it; and bilinearly between pixel centres.
double clamped(const ImageF& image, int x, int y);
double bilinear(const ImageF& image, const glm::dvec2& at);

/// Gives each pixel four numbers in [0,1).
using Noise = std::function<glm::dvec4(int x, int y)>;
/// The hash pcg4d of pixel, seed and stream, 24 bits (Jarzynski and Olano, Hash Functions for GPU Rendering,
/// 2020).
Noise hash_noise(std::uint64_t seed, std::uint32_t stream = 0);
/// The R2 sequence along a Hilbert curve of 64x64 pixels: two numbers; the others are 0.
Noise hilbert_noise();
/// The program's tile of 4x4 pixels, which is an input.
Noise tiled_noise(std::uint64_t seed);

/// Points of a kernel and two numbers in [0,1) a sample, which the program generates: inputs too.
using Kernel3 = std::vector<glm::dvec3>;
using Numbers = std::vector<glm::dvec2>;
Kernel3 points_of(const Kernel& kernel, std::uint64_t seed);
Numbers sample_numbers(int samples, std::uint64_t seed);

}  // namespace aoscore::testing::published
