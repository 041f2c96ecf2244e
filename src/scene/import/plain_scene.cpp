#include "scene/import/plain_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace aoscore::imported {
namespace {

constexpr std::uint64_t kMagic = 0x0131454E45435341;  // "ASCENE1" and a version
constexpr std::size_t kMaxTextBytes = 4096;
constexpr std::size_t kMaxParts = 4'000'000;       // limit for all but vertices, triangles and texels
constexpr std::size_t kMaxVertices = 192'000'000;  // three for each triangle that a scene may have
constexpr int kMaxTextureSide = 8192;

/// Says that the bytes are no scene; thrown and caught in this file alone.
struct NoScene : std::runtime_error {
    using std::runtime_error::runtime_error;
};

void require(bool holds, const char* what) {
    if (!holds) throw NoScene(what);
}

class Writer {
  public:
    explicit Writer(const std::function<void(const void*, std::size_t)>& write) : write_(write) {}

    template <class T>
    void value(const T& v) {
        static_assert(std::is_trivially_copyable_v<T>);
        write_(&v, sizeof v);
    }
    template <class T>
    void array(const std::vector<T>& values, std::size_t) {
        value(static_cast<std::uint64_t>(values.size()));
        if (!values.empty()) write_(values.data(), values.size() * sizeof(T));
    }
    void text(const std::string& text) {
        value(static_cast<std::uint64_t>(std::min(text.size(), kMaxTextBytes)));
        write_(text.data(), std::min(text.size(), kMaxTextBytes));
    }
    template <class T, class Each>
    void list(const std::vector<T>& items, Each each) {
        value(static_cast<std::uint64_t>(items.size()));
        for (const T& item : items) each(*this, item);
    }

  private:
    const std::function<void(const void*, std::size_t)>& write_;
};

class Reader {
  public:
    explicit Reader(const std::function<std::size_t(void*, std::size_t)>& read) : read_(read) {}

    template <class T>
    void value(T& v) {
        static_assert(std::is_trivially_copyable_v<T>);
        bytes(&v, sizeof v);
    }
    template <class T>
    void array(std::vector<T>& values, std::size_t most) {
        constexpr std::size_t kStep = (std::size_t{1} << 22) / sizeof(T);
        const std::size_t size = count(most);
        while (values.size() < size) {
            const std::size_t known = values.size(), more = std::min(size - known, std::max(kStep, known));
            values.resize(known + more);
            bytes(values.data() + known, more * sizeof(T));
        }
    }
    void text(std::string& text) {
        text.resize(count(kMaxTextBytes));
        bytes(text.data(), text.size());
    }
    template <class T, class Each>
    void list(std::vector<T>& items, Each each) {
        const std::size_t size = count(kMaxParts);
        for (std::size_t i = 0; i < size; ++i) each(*this, items.emplace_back());
    }

  private:
    std::size_t count(std::size_t most) {
        std::uint64_t n = 0;
        value(n);
        require(n <= most, "a count");
        return static_cast<std::size_t>(n);
    }
    void bytes(void* to, std::size_t size) {
        auto* at = static_cast<char*>(to);
        while (size > 0) {
            const std::size_t got = read_(at, size);
            require(got > 0, "too short");
            at += got;
            size -= got;
        }
    }

    const std::function<std::size_t(void*, std::size_t)>& read_;
};

// These functions describe the format once, for both directions: an Archive is a Writer, or a Reader that
// fills its arguments. Enumerations are stored as numbers and checked with everything else.

template <class Archive, class T>
void exchange_texture(Archive& archive, T& texture) {
    archive.value(texture.texels.width);
    archive.value(texture.texels.height);
    archive.value(texture.wrap_s);
    archive.value(texture.wrap_t);
    archive.array(texture.texels.pixels, std::size_t{kMaxTextureSide} * kMaxTextureSide);
}

template <class Archive, class T>
void exchange_material(Archive& archive, T& material) {
    archive.text(material.name);
    archive.value(material.base_color);
    archive.value(material.texture);
    archive.value(material.alpha_cutoff);
}

template <class Archive, class T>
void exchange_mesh(Archive& archive, T& mesh) {
    archive.array(mesh.positions, kMaxVertices);
    archive.array(mesh.normals, kMaxVertices);
    archive.array(mesh.texcoords, kMaxVertices);
    archive.array(mesh.triangles, kMaxVertices);
    archive.value(mesh.material);
}

template <class Archive, class T>
void exchange_instance(Archive& archive, T& instance) {
    archive.value(instance.mesh);
    archive.value(instance.scene_from_mesh);
}

template <class Archive, class T>
void exchange_view(Archive& archive, T& view) {
    archive.text(view.id);
    archive.text(view.source);
    archive.value(view.camera);
}

void exchange_flag(Writer& archive, bool flag) {
    archive.value(static_cast<std::uint8_t>(flag));
}
void exchange_flag(Reader& archive, bool& flag) {
    std::uint8_t number = 0;
    archive.value(number);
    flag = number != 0;
}

template <class Archive, class T>
void exchange(Archive& archive, T& plain) {
    std::uint64_t magic = kMagic;
    archive.value(magic);
    require(magic == kMagic, "another format");
    archive.text(plain.refusal);
    archive.value(plain.metres_per_unit);
    archive.value(plain.y_up_from_file);
    exchange_flag(archive, plain.states_axes);
    const auto text = [](auto& a, auto& t) { a.text(t); };
    archive.list(plain.scene.warnings, text);
    archive.list(plain.scene.textures, [](auto& a, auto& t) { exchange_texture(a, t); });
    archive.list(plain.scene.materials, [](auto& a, auto& m) { exchange_material(a, m); });
    archive.list(plain.scene.meshes, [](auto& a, auto& m) { exchange_mesh(a, m); });
    archive.list(plain.scene.instances, [](auto& a, auto& i) { exchange_instance(a, i); });
    archive.list(plain.scene.views, [](auto& a, auto& v) { exchange_view(a, v); });
    magic = kMagic;
    archive.value(magic);  // a truncated scene does not end with it
    require(magic == kMagic, "another format");
}

bool is_finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool is_index(int index, std::size_t size) {
    return index >= 0 && static_cast<std::size_t>(index) < size;
}

bool is_wrap(Texture::Wrap wrap) {
    return wrap <= Texture::Wrap::clamp_to_edge;
}

void check_texture(const Texture& texture) {
    const Image<glm::u8vec4>& texels = texture.texels;
    require(texels.width > 0 && texels.width <= kMaxTextureSide, "a texture's width");
    require(texels.height > 0 && texels.height <= kMaxTextureSide, "a texture's height");
    require(texels.size() == static_cast<std::size_t>(texels.width) * static_cast<std::size_t>(texels.height),
            "a texture's texels");
    require(is_wrap(texture.wrap_s) && is_wrap(texture.wrap_t), "a texture's wrap");
}

void check_material(const Material& material, std::size_t textures) {
    for (int c = 0; c < 4; ++c) {
        require(material.base_color[c] >= 0 && material.base_color[c] <= 1, "a colour");
    }
    require(material.alpha_cutoff >= 0 && material.alpha_cutoff <= 1, "a cut-off");
    require(material.texture == -1 || is_index(material.texture, textures), "a material's texture");
}

void check_mesh(const Mesh& mesh, const Scene& scene) {
    const std::size_t vertices = mesh.positions.size();
    require(is_index(mesh.material, scene.materials.size()), "a mesh's material");
    require(!mesh.triangles.empty(), "a mesh without triangles");
    require(mesh.normals.empty() || mesh.normals.size() == vertices, "a mesh's normals");
    require(mesh.texcoords.empty() || mesh.texcoords.size() == vertices, "a mesh's texture coordinates");
    const bool is_textured = scene.materials[static_cast<std::size_t>(mesh.material)].texture >= 0;
    require(!is_textured || !mesh.texcoords.empty(), "a textured mesh without texture coordinates");
    for (const glm::vec3& p : mesh.positions) require(is_finite(p), "a position");
    for (const glm::vec2& uv : mesh.texcoords) {
        require(std::isfinite(uv.x) && std::isfinite(uv.y), "a texture coordinate");
    }
    for (const glm::uvec3& t : mesh.triangles) {
        require(t.x < vertices && t.y < vertices && t.z < vertices, "an index");
    }
}

void check(const PlainScene& plain) {
    const Scene& scene = plain.scene;
    require(plain.metres_per_unit >= 0 && std::isfinite(plain.metres_per_unit), "a unit");
    for (int column = 0; column < 3; ++column) require(is_finite(plain.y_up_from_file[column]), "an axis");
    for (const Texture& texture : scene.textures) check_texture(texture);
    for (const Material& material : scene.materials) check_material(material, scene.textures.size());
    for (const Mesh& mesh : scene.meshes) check_mesh(mesh, scene);
    for (const Instance& instance : scene.instances) {
        require(is_index(instance.mesh, scene.meshes.size()), "an instance's mesh");
        for (int column = 0; column < 4; ++column) {
            require(is_finite(glm::dvec3(instance.scene_from_mesh[column])), "a transform");
            require(instance.scene_from_mesh[column][3] == (column == 3 ? 1 : 0), "a transform's last row");
        }
    }
}

}  // namespace

void write_plain_scene(const PlainScene& plain,
                       const std::function<void(const void* data, std::size_t size)>& write) {
    Writer writer(write);
    exchange(writer, plain);
}

std::optional<PlainScene> read_plain_scene(
    const std::function<std::size_t(void* to, std::size_t size)>& read) {
    PlainScene plain;
    try {
        Reader reader(read);
        exchange(reader, plain);
        if (plain.refusal.empty()) check(plain);
    } catch (const NoScene&) {
        return std::nullopt;
    }
    return plain;
}

}  // namespace aoscore::imported
