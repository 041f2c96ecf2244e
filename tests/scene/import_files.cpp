#include "import_files.h"

#include "core/error.h"
#include "gltf_file.h"
#include "support/support.h"

#include <gtest/gtest.h>

#include <fstream>

namespace aoscore::testing {

ImportFolder::ImportFolder() : folder_(output_dir()) {}

std::filesystem::path ImportFolder::write(const std::string& name, std::string_view content) const {
    const std::filesystem::path path = folder_ / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << content;
    return path;
}

void ImportFolder::write_png(const std::string& name, const Image<glm::u8vec4>& texels) const {
    write(name, png_bytes(texels));
}

Scene ImportFolder::load(const std::string& name, std::string_view content,
                         const LoadOptions& options) const {
    return load_scene(write(name, content).string(), options);
}

std::string ImportFolder::refusal(const std::string& name, std::string_view content) const {
    try {
        load(name, content);
        return "";
    } catch (const Error& error) {
        const std::string message = error.what();
        EXPECT_EQ(error.exit_code(), ExitCode::file_error) << message;
        EXPECT_NE(message.find(name), std::string::npos) << message;
        EXPECT_LT(message.size(), 600u) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        return message;
    }
}

double area_of(const Scene& scene) {
    const std::vector<glm::dvec3> points = all_corners(scene);
    double area = 0;
    for (std::size_t i = 0; i + 2 < points.size(); i += 3)
        area += glm::length(glm::cross(points[i + 1] - points[i], points[i + 2] - points[i])) / 2;
    return area;
}

std::string warnings_of(const Scene& scene) {
    std::string text;
    for (const std::string& warning : scene.warnings) text += warning + "\n";
    return text;
}

}  // namespace aoscore::testing
