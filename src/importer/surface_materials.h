#pragma once

#include "core/memory_budget.h"
#include "importer/import_job.h"
#include "scene/scene.h"

#include <glm/glm.hpp>

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace aoscore::importer {

/// An image as a material uses it. Texture coordinates are the file's, v upwards.
struct TextureUse {
    std::string name;  ///< as the file has it; empty: none
    Texture::Wrap wrap_s = Texture::Wrap::repeat, wrap_t = Texture::Wrap::repeat;
    glm::vec2 scale{1}, offset{0};  ///< of the texture coordinates
    unsigned texcoord_set = 0;
    char channel =
        'm';  ///< of an opacity: r, g, b, l (luminance), or m: alpha where there is any, else luminance
};

/// What of a material of any format matters here.
struct MaterialSource {
    std::string name;
    glm::vec3 color{1};
    float opacity = 1;  ///< 1: solid
    TextureUse color_map, opacity_map;
};

/// Turns materials into those of a scene: what is less than half opaque is a hole, in the manner of a glTF
/// material of alpha mode MASK with a cut-off of 0.5. Images are read from the scene's folder.
class SurfaceMaterials {
  public:
    explicit SurfaceMaterials(ImportJob& job) : job_(job) {}

    /// Adds it to the scene's materials. The index is that of the one added; the use is that of the texture
    /// which the material ended up with, whose texture coordinates its meshes need; nothing: they need none.
    std::optional<TextureUse> add(const MaterialSource& source);

    /// To be called after the last add(): warns of all images that are not there.
    void finish();

    /// Bytes of images that the scene's file itself holds, by their name; nothing for another name.
    std::function<std::optional<std::string_view>(const std::string& name)> embedded;

  private:
    using Texels = Image<glm::u8vec4>;
    std::optional<std::string> bytes_of(const std::string& name) const;
    const Texels* image(const std::string& name);
    bool may_cut(const std::string& name);
    bool cuts_by_color_alpha(const MaterialSource& source);
    int add_texture(const TextureUse& use, Texels texels);

    ImportJob& job_;
    MemoryBudget budget_;
    std::map<std::string, std::optional<Texels>> images_;
    std::map<std::string, bool> may_cut_;
    std::set<std::string> missing_;
};

}  // namespace aoscore::importer
