#include "jobs/recorded/frame_normals.h"

#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace aoscore {
namespace {

// Normals that lie within this of the depth's are taken to fit it.
constexpr float kFitCosine = 0.8F;
// Bumps and creases leave well over half of all pixels within that; a wrong space or angle does not.
constexpr double kLeastFit = 0.5;
// Other signs are named where most normals fit by them, and many more than by these.
constexpr double kClearFit = 0.8, kClearGain = 0.1;
// Eight bits a component change a unit vector's length by less.
constexpr float kUnitLength = 0.05F;

class NormalReader {
  public:
    NormalReader(const ImageFile& file, const FrameLayout& layout, const FrameCamera& camera,
                 const Mask& surface, const Image<glm::vec3>& from_depth, const std::string& where)
        : file_(file), layout_(layout), surface_(surface), from_depth_(from_depth), where_(where) {
        if (camera.world_normals.value_or(layout.world_normals)) rotation_ = camera.view_from_world;
        signs_ = camera.normal_signs;
        needs_rotation_ = camera.world_normals.value_or(layout.world_normals);
        as_written_ = layout.turned && file.attributes.contains(std::string(layout.attribute)) &&
                      !needs_rotation_ && signs_ == glm::dvec3(1);
    }

    struct Read {
        Image<glm::vec3> normals;
        std::string channel;
        double fitting = 0;        ///< share of surface pixels whose normals fit the depth
        bool doubtful = false;     ///< whether too few fit, or other signs fit better
        std::size_t replaced = 0;  ///< surface pixels without a normal, which have the depth's
        std::string better;        ///< other signs by which they would fit, in words; empty without such
    };
    /// Empty where the file has none of these channels.
    std::optional<Read> read(const std::vector<std::string_view>& names) const {
        const std::optional<std::size_t> first = find_channel(layout_, names, file_);
        if (!first) return std::nullopt;
        const auto channels = three_channels(*first, file_);
        const std::string& channel = file_.channel_names[*first];
        if (!channels)
            throw file_error("has no neighbours for y and z", where_ + ": " + channel,
                             "normals of three components: octahedral and other codings are not read");
        if (needs_rotation_ && !rotation_)
            throw file_error("holds normals in world space", where_ + ": " + channel,
                             R"(world_to_camera in the camera file, or "normals": "view")");
        refuse_two_components(*channels);
        Read result = with_signs(*channels, signs_);
        add_better_signs(*channels, result);
        // Own normals of hair, finer than a pixel, fit the depth in a seventh of the pixels.
        const bool few_fit = !as_written_ && result.fitting < kLeastFit;
        result.doubtful = few_fit || !result.better.empty();
        return result;
    }

  private:
    Read with_signs(const std::vector<std::size_t>& channels, const glm::dvec3& signs) const {
        Read result{from_depth_, file_.channel_names[channels[0]], 0, false, 0, {}};
        std::size_t surfaces = 0, fitting = 0;
        for (std::size_t i = 0; i < surface_.size(); ++i) {
            if (surface_.pixels[i] == 0) continue;
            ++surfaces;
            const std::optional<glm::vec3> normal = normal_at(channels, i, signs);
            result.replaced += !normal;
            if (normal) result.normals.pixels[i] = *normal;
            fitting += std::abs(glm::dot(result.normals.pixels[i], from_depth_.pixels[i])) > kFitCosine;
        }
        result.fitting =
            static_cast<double>(fitting) / static_cast<double>(std::max<std::size_t>(surfaces, 1));
        return result;
    }

    /// Looks for other signs of the axes by which the normals fit: y or z point the other way in many
    /// programs. As normals are turned to the camera, three signs mean the same as their opposites.
    void add_better_signs(const std::vector<std::size_t>& channels, Read& result) const {
        double best = std::max(kClearFit, result.fitting + kClearGain);
        for (const glm::dvec3& turn : {glm::dvec3(1, -1, 1), glm::dvec3(1, 1, -1), glm::dvec3(1, -1, -1)}) {
            const glm::dvec3 signs = signs_ * turn;
            const double fitting = with_signs(channels, signs).fitting;
            if (fitting < best) continue;
            best = fitting;
            result.better = fmt::format(
                R"(; with "normal_signs": [{:g}, {:g}, {:g}] in the camera file they fit in {:.0f} %)",
                signs.x, signs.y, signs.z, 100 * fitting);
        }
    }

    /// The components as the file has them, from -1 to 1.
    glm::vec3 stored_at(const std::vector<std::size_t>& channels, std::size_t i) const {
        glm::vec3 n;
        for (int axis = 0; axis < 3; ++axis)
            n[axis] = file_.channels[channels[static_cast<std::size_t>(axis)]].pixels[i];
        return layout_.packed_normals ? 2.0F * n - 1.0F : n;
    }

    /// Throws file_error where the third component is one number everywhere and the vectors are no unit
    /// vectors: octahedral, spheremap and other codings leave two numbers.
    void refuse_two_components(const std::vector<std::size_t>& channels) const {
        std::size_t surfaces = 0, other_lengths = 0;
        float least = 2, most = -2;
        for (std::size_t i = 0; i < surface_.size(); ++i) {
            if (surface_.pixels[i] == 0) continue;
            const glm::vec3 n = stored_at(channels, i);
            least = std::min(least, n.z);
            most = std::max(most, n.z);
            ++surfaces;
            other_lengths += std::abs(glm::length(n) - 1) > kUnitLength;
        }
        if (surfaces == 0 || most > least || 2 * other_lengths < surfaces) return;
        throw file_error("holds the same third component everywhere, so that its normals are coded in two",
                         where_ + ": " + file_.channel_names[channels[0]],
                         "normals of three components: octahedral and other codings are not read");
    }

    std::optional<glm::vec3> normal_at(const std::vector<std::size_t>& channels, std::size_t i,
                                       const glm::dvec3& signs) const {
        glm::vec3 n = stored_at(channels, i);
        if (glm::any(glm::isnan(n)))
            throw file_error("a surface's normal is NaN", where_ + ": " + file_.channel_names[channels[0]]);
        if (as_written_ && signs == signs_) return n;
        n *= glm::vec3(signs);
        if (rotation_) n = glm::vec3(*rotation_ * glm::dvec3(n));
        const float length = glm::length(n);
        if (!(length > 1e-3F)) return std::nullopt;
        n /= length;
        return glm::dot(n, from_depth_.pixels[i]) < 0 ? -n : n;
    }

    const ImageFile& file_;
    const FrameLayout& layout_;
    const Mask& surface_;
    const Image<glm::vec3>& from_depth_;
    const std::string& where_;
    std::optional<glm::dmat3> rotation_;
    bool needs_rotation_ = false;
    bool as_written_ = false;  ///< this program wrote them, to be taken to the bit
    glm::dvec3 signs_{1, 1, 1};
};

}  // namespace

void add_normals(const ImageFile& file, const FrameLayout& layout, const FrameCamera& camera,
                 const Image<glm::vec3>& from_depth, const std::string& where, GBufferImages& images,
                 std::string& read_as, std::vector<std::string>& warnings) {
    const NormalReader reader(file, layout, camera, images.surface, from_depth, where);
    auto geometric = reader.read(layout.normal_geometric), smooth = reader.read(layout.normal_smooth);
    for (const auto* read : {&geometric, &smooth}) {
        if (!*read) continue;
        if ((*read)->doubtful)
            warnings.push_back(
                fmt::format("the normals {} fit the depth in {:.0f} % of the pixels: another space, angle of "
                            "view, or row "
                            "order{}",
                            (*read)->channel, 100 * (*read)->fitting, (*read)->better));
        if ((*read)->replaced > 0)
            warnings.push_back(fmt::format("{} surface pixels of {} have no normal, and get one from depth",
                                           (*read)->replaced, (*read)->channel));
    }
    if (geometric && smooth) {
        read_as += fmt::format("; normals {} and {}", geometric->channel, smooth->channel);
    } else if (geometric || smooth) {
        const NormalReader::Read& only = geometric ? *geometric : *smooth;
        read_as += fmt::format("; normals {}, for triangles' and interpolated ones alike", only.channel);
    } else {
        read_as += "; normals from depth, since the frame has none";
        geometric.emplace(NormalReader::Read{from_depth, {}, 1, false, 0, {}});
    }
    images.vectors["normal_geometric"] = geometric ? geometric->normals : smooth->normals;
    images.vectors["normal_smooth"] = smooth ? smooth->normals : geometric->normals;
}

}  // namespace aoscore
