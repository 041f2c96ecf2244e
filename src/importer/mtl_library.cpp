#include "importer/mtl_library.h"

#include "core/counted.h"
#include "importer/tiny_obj.h"
#include "scene/gltf/place.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace aoscore::importer {
namespace {

TextureUse texture_use(const std::string& name, const tinyobj::texture_option_t& options) {
    TextureUse use;
    use.name = name;
    use.wrap_s = use.wrap_t = options.clamp ? Texture::Wrap::clamp_to_edge : Texture::Wrap::repeat;
    use.scale = {options.scale[0], options.scale[1]};
    use.offset = {options.origin_offset[0], options.origin_offset[1]};
    use.channel = options.imfchan;
    return use;
}

MaterialSource source_of(const tinyobj::material_t& mtl) {
    MaterialSource source;
    source.name = mtl.name;
    source.color = {mtl.diffuse[0], mtl.diffuse[1], mtl.diffuse[2]};
    source.opacity = static_cast<float>(mtl.dissolve);
    source.color_map = texture_use(mtl.diffuse_texname, mtl.diffuse_texopt);
    source.opacity_map = texture_use(mtl.alpha_texname, mtl.alpha_texopt);
    return source;
}

std::vector<std::string> words(const std::string& text) {
    std::istringstream in(text);
    return {std::istream_iterator<std::string>(in), {}};
}

}  // namespace

MtlLibrary::MtlLibrary(ImportJob& job, const std::vector<std::string>& names) : job_(job), materials_(job) {
    std::set<std::string> known;
    for (const std::string& name : names) {
        // A name with blanks is one name, unless only its single words are files.
        const bool is_one = job.folder.find(name).has_value() || name.find(' ') == std::string::npos;
        for (const std::string& library : is_one ? std::vector<std::string>{name} : words(name)) {
            if (known.insert(library).second) read(library);
        }
    }
    distrust_opacity();
}

void MtlLibrary::read(const std::string& library) {
    const std::optional<std::string> text = job_.folder.read(library);
    if (!text) {
        job_.warn(
            fmt::format("the material library {} is not in the scene's folder: what it would cut is solid",
                        gltf::printable(library)));
        return;
    }
    std::istringstream in(*text);
    std::map<std::string, int> index_of_name;
    std::vector<tinyobj::material_t> found;
    std::string warnings, errors;
    tinyobj::LoadMtl(&index_of_name, &found, &in, &warnings, &errors);
    for (const tinyobj::material_t& mtl : found) sources_.try_emplace(mtl.name, source_of(mtl));
}

/// Ignores the opacity of a file without one solid material: Tr is 1 - d in most programs and d in others,
/// and some write 0 for both.
void MtlLibrary::distrust_opacity() {
    const bool all = std::all_of(sources_.begin(), sources_.end(),
                                 [](const auto& entry) { return entry.second.opacity < 0.5f; });
    if (!all || sources_.empty()) return;
    job_.warn(
        "every material is less than half opaque (d or Tr): taken for a fault of the file, and as solid");
    for (auto& [name, source] : sources_) source.opacity = 1;
}

const MtlLibrary::Used& MtlLibrary::use(const std::string& name) {
    const auto [entry, is_new] = used_.try_emplace(name);
    if (is_new) {
        const auto source = sources_.find(name);
        if (source == sources_.end() && !name.empty()) unknown_.insert(gltf::printable(name));
        MaterialSource plain;
        plain.name = name;
        entry->second.material = static_cast<int>(job_.plain.scene.materials.size());
        entry->second.texture = materials_.add(source == sources_.end() ? plain : source->second);
    }
    return entry->second;
}

void MtlLibrary::finish() {
    materials_.finish();
    if (unknown_.empty()) return;
    job_.warn(fmt::format("{} in no library, such as {}: drawn solid",
                          counted(unknown_.size(), "material is", "materials are"), *unknown_.begin()));
}

}  // namespace aoscore::importer
