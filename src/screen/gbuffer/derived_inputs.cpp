#include "screen/gbuffer/derived_inputs.h"

#include "core/folders.h"
#include "screen/gbuffer/precision.h"
#include "screen/gl/texture.h"
#include "screen/passes/pass_program.h"

#include <fmt/format.h>

#include <algorithm>

namespace aoscore {

void DerivedInputs::forget() {
    textures_.clear();
}

const ShaderProgram& DerivedInputs::program(const GBuffer& gbuffer, const std::string& file,
                                            const std::string& macros) {
    const std::string all =
        fmt::format("#define ORTHOGRAPHIC {}\n{}", gbuffer.orthographic() ? 1 : 0, macros);
    const auto found = programs_.find(file + all);
    if (found != programs_.end()) return found->second;
    const auto folder = data_dir() / "shaders" / "gbuffer";
    ShaderSource vertex, fragment;
    vertex.add_file(folder / "screen.vert", folder);
    fragment.add_block("(program's macros)", all);
    fragment.add_file(folder / file, folder);
    return programs_.emplace(file + all, ShaderProgram(file, vertex, fragment)).first->second;
}

void DerivedInputs::draw(const GBuffer& gbuffer, const ShaderProgram& p, GLuint source,
                         const Target& target) {
    if (!empty_vertices_) empty_vertices_ = gl::VertexArray::create();
    const gl::Framebuffer framebuffer = make_framebuffer(target.textures, target.level);
    gl::Viewport(0, 0, target.width, target.height);
    gl::ActiveTexture(GL_TEXTURE0);
    gl::BindTexture(GL_TEXTURE_2D, source);
    gbuffer.set_view_uniforms(p);
    gl::BindVertexArray(empty_vertices_.name());
    gl::DrawArrays(GL_TRIANGLES, 0, 3);
    gl::BindFramebuffer(GL_FRAMEBUFFER, 0);
}

GLuint DerivedInputs::depth_mips(const GBuffer& gbuffer, GLuint linear_depth, const std::string& filter,
                                 double radius_m, Mirror mirror) {
    const std::string mirrored = mirror_macros(mirror);
    const std::string key = fmt::format("depth_mips {} {} {} {}", linear_depth, filter, radius_m, mirrored);
    if (const auto found = textures_.find(key); found != textures_.end()) return found->second.name();
    gl::Texture mips = make_mipmapped_texture(kR32F, gbuffer.width(), gbuffer.height(), kMipLevels);
    const ShaderProgram& p =
        program(gbuffer, "depth_mip.frag",
                fmt::format("#define WEIGHTED {}\n{}", filter == "weighted" ? 1 : 0, mirrored));
    p.use();
    gl::Uniform1i(p.location("u_source"), 0);
    gl::Uniform1f(p.location("u_radius"), static_cast<float>(radius_m));
    for (int level = 0; level < kMipLevels; ++level) {
        gl::Uniform1i(p.location("u_source_level"), level - 1);
        const GLuint source = level == 0 ? linear_depth : mips.name();
        if (level > 0) {
            // A level may be read while another is drawn only when the sampler cannot access the drawn one.
            gl::BindTexture(GL_TEXTURE_2D, mips.name());
            gl::TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, level - 1);
        }
        draw(gbuffer, p, source,
             {{mips.name()},
              std::max(gbuffer.width() >> level, 1),
              std::max(gbuffer.height() >> level, 1),
              level});
    }
    gl::BindTexture(GL_TEXTURE_2D, mips.name());
    gl::TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, kMipLevels - 1);
    gl::check("making depth mips");
    return textures_.emplace(key, std::move(mips)).first->second.name();
}

GLuint DerivedInputs::normal_from_depth(const GBuffer& gbuffer, GLuint linear_depth, bool accurate) {
    const std::string key = fmt::format("normal_from_depth {} {}", linear_depth, accurate);
    if (const auto found = textures_.find(key); found != textures_.end()) return found->second.name();
    gl::Texture normals = make_texture(kRgba32F, gbuffer.width(), gbuffer.height());
    const ShaderProgram& p =
        program(gbuffer, "normal_from_depth.frag", fmt::format("#define ACCURATE {}\n", accurate ? 1 : 0));
    p.use();
    gl::Uniform1i(p.location("u_linear_depth"), 0);
    draw(gbuffer, p, linear_depth, {{normals.name()}, gbuffer.width(), gbuffer.height()});
    gl::check("making normals from depth");
    return textures_.emplace(key, std::move(normals)).first->second.name();
}

GLuint DerivedInputs::half_depth(const GBuffer& gbuffer, GLuint linear_depth) {
    const std::string key = fmt::format("half_depth {}", linear_depth);
    if (const auto found = textures_.find(key); found != textures_.end()) return found->second.name();
    const int width = (gbuffer.width() + 1) / 2, height = (gbuffer.height() + 1) / 2;
    gl::Texture depth = make_texture(kR32F, width, height);
    const ShaderProgram& p = program(gbuffer, "half_depth.frag", "");
    p.use();
    gl::Uniform1i(p.location("u_source"), 0);
    draw(gbuffer, p, linear_depth, {{depth.name()}, width, height});
    gl::check("halving the depth");
    return textures_.emplace(key, std::move(depth)).first->second.name();
}

const ShaderProgram& DerivedInputs::storing_program(const GBuffer& gbuffer, const std::string& file,
                                                    std::string_view PrecisionFormat::*of,
                                                    std::string_view stored) {
    std::string macros;
    int number = 0;
    for (const PrecisionFormat& format : precision_formats()) {
        if (!(format.*of).empty()) macros += fmt::format("#define {} {}\n", format.*of, ++number);
    }
    return program(gbuffer, file, macros + fmt::format("#define STORED {}\n", stored));
}

GLuint DerivedInputs::stored_depth(const GBuffer& gbuffer, std::string_view stored) {
    const std::string key = fmt::format("stored_depth {}", stored);
    if (const auto found = textures_.find(key); found != textures_.end()) return found->second.name();
    const bool positions = std::ranges::any_of(precision_formats(), [&](const PrecisionFormat& format) {
        return format.stored == stored && format.positions;
    });
    gl::Texture depth = make_texture(positions ? kRgba32F : kR32F, gbuffer.width(), gbuffer.height());
    const ShaderProgram& p = storing_program(gbuffer, "stored_depth.frag", &PrecisionFormat::stored, stored);
    p.use();
    gl::Uniform1i(p.location("u_linear_depth"), 0);
    gl::Uniform1i(p.location("u_hardware_depth"), 1);
    gl::ActiveTexture(GL_TEXTURE1);
    gl::BindTexture(GL_TEXTURE_2D, gbuffer.texture("hardware_depth"));
    draw(gbuffer, p, gbuffer.texture("linear_depth"), {{depth.name()}, gbuffer.width(), gbuffer.height()});
    gl::check("storing depth");
    return textures_.emplace(key, std::move(depth)).first->second.name();
}

GLuint DerivedInputs::stored_normal(const GBuffer& gbuffer, GLuint normal, std::string_view stored) {
    const std::string key = fmt::format("stored_normal {} {}", stored, normal);
    if (const auto found = textures_.find(key); found != textures_.end()) return found->second.name();
    gl::Texture normals = make_texture(kRgba32F, gbuffer.width(), gbuffer.height());
    const ShaderProgram& p =
        storing_program(gbuffer, "stored_normal.frag", &PrecisionFormat::normals, stored);
    p.use();
    gl::Uniform1i(p.location("u_normal"), 0);
    draw(gbuffer, p, normal, {{normals.name()}, gbuffer.width(), gbuffer.height()});
    gl::check("storing normals");
    return textures_.emplace(key, std::move(normals)).first->second.name();
}

}  // namespace aoscore
