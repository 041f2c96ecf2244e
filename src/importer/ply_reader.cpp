#include "importer/ply_reader.h"

#include "core/error.h"
#include "core/files.h"
#include "importer/ply_numbers.h"
#include "importer/surface_builder.h"
#include "importer/surface_materials.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace aoscore::importer {
namespace {

constexpr std::size_t kMaxPlyBytes = std::size_t{4} << 30;

/// The properties of a vertex that are read, by their names.
enum Slot : std::size_t { x, y, z, nx, ny, nz, u, v, alpha, slots };
struct SlotName {
    std::string_view name;
    Slot slot;
};
constexpr SlotName kSlotNames[] = {
    {"x", x}, {"y", y}, {"z", z}, {"nx", nx},       {"ny", ny},       {"nz", nz},      {"u", u},
    {"v", v}, {"s", u}, {"t", v}, {"alpha", alpha}, {"texture_u", u}, {"texture_v", v}};

std::optional<Slot> slot_of(const PlyProperty& property) {
    if (property.count_type) return std::nullopt;
    for (const SlotName& row : kSlotNames) {
        if (row.name == property.name) return row.slot;
    }
    return std::nullopt;
}

/// Half of the greatest alpha of that type.
double half_of(PlyNumber type) {
    return type >= PlyNumber::float32 ? 0.5 : std::ldexp(1.0, 8 * static_cast<int>(size_of(type)) - 1);
}

/// Takes the elements in the order of the file, and builds a mesh at its end.
class PlyAssembly {
  public:
    PlyAssembly(std::string_view content, const PlyHeader& header) : numbers_(content, header) {}

    void read(const PlyElement& element) {
        if (element.properties.empty()) return;
        const auto read_row = element.name == "vertex"      ? &PlyAssembly::read_vertex
                              : element.name == "face"      ? &PlyAssembly::read_face
                              : element.name == "tristrips" ? &PlyAssembly::read_strips
                                                            : &PlyAssembly::pass_over;
        if (element.name == "vertex") note_attributes(element);
        for (std::uint64_t row = 0; row < element.count; ++row) {
            numbers_.begin(element.name, row);
            (this->*read_row)(element);
        }
    }

    void build(ImportJob& job, const PlyHeader& header) {
        if (!numbers_.at_end()) job.warn("it holds more than its header states: what is left is not read");
        if (faces_.empty() && !vertices_.empty())
            job.warn(fmt::format("{} points are left out: they have no surface", vertices_.size()));
        const auto lines =
            std::count_if(faces_.begin(), faces_.end(), [](const Face& face) { return face.count < 3; });
        if (lines > 0) job.warn(fmt::format("{} faces of fewer than three corners are left out", lines));
        if (clear_vertices_ > 0)
            job.warn(fmt::format("{} vertices have an alpha below one half: drawn solid", clear_vertices_));
        SurfaceMaterials materials(job);
        MaterialSource source;
        if (header.textures.size() == 1) source.color_map.name = header.textures[0];
        if (header.textures.size() > 1) job.warn("it has several textures: what they would cut is solid");
        const std::optional<TextureUse> use = materials.add(source);
        materials.finish();
        const bool wedges = wedges_.size() == corners_.size();
        if (use && !wedges && !has_[u])
            job.warn("it lacks the texture coordinates that its texture needs: taken as 0, 0");
        SurfaceBuilder builder({0, has_[nx] && has_[ny] && has_[nz], use.has_value()});
        add_faces(builder, use.has_value(), wedges);
        if (builder.empty()) return;
        SurfaceBuilder::Built built = builder.take();
        job.plain.scene.meshes.push_back(std::move(built.mesh));
        job.plain.scene.instances.push_back({0, glm::translate(glm::dmat4(1.0), built.centre)});
    }

  private:
    struct Face {
        std::size_t first = 0;  // index into corners_
        std::size_t count = 0;
    };

    void note_attributes(const PlyElement& element) {
        for (const PlyProperty& property : element.properties) {
            if (const auto slot = slot_of(property)) has_[*slot] = true;
        }
        if (!has_[x] || !has_[y] || !has_[z]) throw file_error("has no x, y or z", "element vertex");
    }

    void pass(const PlyProperty& property) {
        numbers_.skip(property.type, property.count_type ? numbers_.next_count(*property.count_type) : 1);
    }

    void pass_over(const PlyElement& element) {
        for (const PlyProperty& property : element.properties) pass(property);
    }

    void read_vertex(const PlyElement& element) {
        std::array<double, slots> value{};
        for (const PlyProperty& property : element.properties) {
            const auto slot = slot_of(property);
            if (!slot) {
                pass(property);
                continue;
            }
            value[*slot] = numbers_.next(property.type);
            if (*slot == alpha && value[alpha] < half_of(property.type)) ++clear_vertices_;
        }
        vertices_.push_back(
            {{value[x], value[y], value[z]}, {value[nx], value[ny], value[nz]}, {value[u], 1 - value[v]}});
    }

    /// Whether the property lists the corners of faces.
    static bool is_corners(const PlyProperty& property) {
        return property.count_type && (property.name == "vertex_indices" || property.name == "vertex_index");
    }

    /// Appends the numbers of a list to `to`.
    template <class T>
    void read_list(const PlyProperty& property, std::vector<T>& to) {
        const std::uint64_t count = numbers_.next_count(*property.count_type);
        for (std::uint64_t i = 0; i < count; ++i) to.push_back(static_cast<T>(numbers_.next(property.type)));
    }

    void read_face(const PlyElement& element) {
        Face face{corners_.size(), 0};
        for (const PlyProperty& property : element.properties) {
            if (is_corners(property)) {
                read_list(property, corners_);
            } else if (property.count_type && property.name == "texcoord") {
                read_list(property, pairs_);
            } else {
                pass(property);
            }
        }
        face.count = corners_.size() - face.first;
        faces_.push_back(face);
        for (std::size_t i = 0; pairs_.size() == 2 * face.count && i < face.count; ++i)
            wedges_.emplace_back(pairs_[2 * i], 1 - pairs_[2 * i + 1]);
        pairs_.clear();
    }

    /// Reads triangle strips, which stand one after the other with -1 between them.
    void read_strips(const PlyElement& element) {
        for (const PlyProperty& property : element.properties) {
            if (!is_corners(property)) {
                pass(property);
                continue;
            }
            std::vector<double> strip;
            read_list(property, strip);
            std::size_t start = 0;
            for (std::size_t i = 0; i < strip.size(); ++i) {
                if (strip[i] == -1) start = i + 1;
                if (strip[i] == -1 || i < start + 2) continue;
                const bool is_odd = (i - start) % 2 != 0;
                faces_.push_back({corners_.size(), 3});
                corners_.insert(corners_.end(),
                                {strip[i - (is_odd ? 1 : 2)], strip[i - (is_odd ? 2 : 1)], strip[i]});
            }
        }
    }

    const Corner& vertex(double index, std::size_t face) const {
        if (!(index >= 0 && index < static_cast<double>(vertices_.size()) && index == std::floor(index))) {
            throw file_error(fmt::format("names vertex {} of {}", index, vertices_.size()),
                             fmt::format("face {}", face + 1), "indices that count from 0");
        }
        return vertices_[static_cast<std::size_t>(index)];
    }

    void add_faces(SurfaceBuilder& builder, bool texcoords, bool wedges) const {
        const bool normals = has_[nx] && has_[ny] && has_[nz];
        std::vector<Corner> polygon;
        for (std::size_t f = 0; f < faces_.size(); ++f) {
            polygon.clear();
            for (std::size_t i = faces_[f].first; i < faces_[f].first + faces_[f].count; ++i) {
                Corner& corner = polygon.emplace_back(vertex(corners_[i], f));
                if (texcoords && wedges) corner.texcoord = wedges_[i];
                if (!texcoords) corner.texcoord = glm::vec2(0);
                if (!normals) corner.normal = glm::vec3(0);
            }
            if (polygon.size() >= 3) builder.add(polygon, f + 1);
        }
    }

    PlyNumbers numbers_;
    std::array<bool, slots> has_{};
    std::vector<Corner> vertices_;
    std::vector<Face> faces_;
    std::vector<double> corners_;  // indices, checked when all vertices are known
    std::vector<float> pairs_;     // texture coordinates of a face's corners
    std::vector<glm::vec2> wedges_;
    std::size_t clear_vertices_ = 0;
};

}  // namespace

void read_ply(ImportJob& job) {
    const std::string content = read_file(job.file, kMaxPlyBytes);
    const PlyHeader header = read_ply_header(content);
    PlyAssembly ply(content, header);
    for (const PlyElement& element : header.elements) ply.read(element);
    ply.build(job, header);
}

}  // namespace aoscore::importer
