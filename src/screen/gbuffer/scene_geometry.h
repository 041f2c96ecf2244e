#pragma once

#include "scene/scene.h"
#include "screen/gl/gl_objects.h"

#include <vector>

namespace aoscore {

/// A scene's triangles and base-colour textures on the GPU: all meshes in one set of buffers, drawn by range.
class SceneGeometry {
  public:
    explicit SceneGeometry(const Scene& scene);

    struct Range {
        int material = 0;
        GLint base_vertex = 0;
        GLsizei index_count = 0;
        std::size_t index_offset = 0;  ///< offset into the index buffer in bytes
        GLint first_triangle = 0;      ///< index into the buffer texture of normals
    };
    struct Draw {
        int range = 0;
        int instance = 0;  ///< index into the scene's instances
        glm::dmat4 scene_from_mesh{1.0};
        bool is_dynamic = false;  ///< as the instance
    };
    const std::vector<Range>& ranges() const { return ranges_; }
    /// All instances, those of solid materials first, since cut-outs need another program.
    const std::vector<Draw>& draws() const { return draws_; }
    const std::vector<Material>& materials() const { return materials_; }

    GLuint vertex_array() const { return vertex_array_.name(); }
    /// A GL_TEXTURE_BUFFER of RGBA32F with the unit normal of each triangle in mesh space, by its winding.
    GLuint triangle_normals() const { return triangle_normals_.name(); }
    /// A texture of RGBA8 with level 0 only; 0 for one that the scene did not decode.
    GLuint texture(int index) const { return textures_[static_cast<std::size_t>(index)].name(); }
    const Texture& texture_info(int index) const { return texture_infos_[static_cast<std::size_t>(index)]; }

  private:
    gl::VertexArray vertex_array_;
    gl::Buffer positions_, normals_, texcoords_, alphas_, indices_, normal_texels_;
    gl::Texture triangle_normals_;
    std::vector<gl::Texture> textures_;
    std::vector<Texture> texture_infos_;  // sizes and wrap modes; no texels
    std::vector<Range> ranges_;
    std::vector<Draw> draws_;
    std::vector<Material> materials_;
};

}  // namespace aoscore
