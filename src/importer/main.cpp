// Reads a scene's file in a process of its own and writes it to standard output, as
// scene/import/plain_scene.h describes it: files come from anywhere, and some make the libraries that read
// them crash or hang.

#include "core/error.h"
#include "image/image_formats.h"
#include "importer/assimp_reader.h"
#include "importer/confinement.h"
#include "importer/obj_reader.h"
#include "importer/ply_reader.h"
#include "scene/import/import_formats.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <exception>
#include <map>
#include <new>
#include <string>
#include <string_view>

namespace aoscore::importer {
namespace {

using Read = void (*)(ImportJob&);

const std::map<imported::Format, Read>& readers() {
    using imported::Format;
    static const std::map<Format, Read> table{
        {Format::obj, read_obj}, {Format::fbx, read_fbx}, {Format::ply, read_ply}, {Format::stl, read_stl}};
    return table;
}

void read(ImportJob& job, imported::Format format) {
    try {
        readers().at(format)(job);
    } catch (const Error& e) {
        job.plain.refusal = e.what();
    } catch (const std::bad_alloc&) {
        job.plain.refusal = "needs more memory than a file of its size may take";
    } catch (const std::exception& e) {
        job.plain.refusal = std::string("cannot be understood: ") + e.what();
    }
    if (!job.plain.refusal.empty()) job.plain.scene = {};
}

void write_to(int file, const void* data, std::size_t size) {
    const char* at = static_cast<const char*>(data);
    while (size > 0) {
        const ssize_t written = write(file, at, size);
        if (written <= 0) _exit(1);  // the reader is gone
        at += written;
        size -= static_cast<std::size_t>(written);
    }
}

}  // namespace
}  // namespace aoscore::importer

int main(int argc, char** argv) {
    using namespace aoscore;
    if (argc < 2) {
        fmt::print(stderr,
                   "usage: aoscore-import FILE [--albedo] >SCENE\n"
                   "Part of aoscore, which starts it for .obj, .fbx, .ply and .stl files.\n");
        return static_cast<int>(ExitCode::usage);
    }
    // Text that a library prints must not get into the scene.
    const int output = dup(STDOUT_FILENO);
    dup2(STDERR_FILENO, STDOUT_FILENO);
    const std::filesystem::path file(argv[1]);
    const std::optional<imported::Format> format = imported::format_of(file);
    if (!format) return static_cast<int>(ExitCode::usage);
    importer::ImportJob job{
        file, importer::SceneFolder(file), argc > 2 && std::string_view(argv[2]) == "--albedo", {}};
    std::error_code ec;
    const std::uintmax_t bytes = std::filesystem::file_size(file, ec);
    // Once it is confined it does not see the libraries that read textures.
    if (*format != imported::Format::stl) image_formats();
    importer::confine(job.folder.path(), ec ? 0 : static_cast<std::size_t>(bytes));
    importer::read(job, *format);
    imported::write_plain_scene(
        job.plain, [output](const void* data, std::size_t size) { importer::write_to(output, data, size); });
    // Ends without the libraries' destructors, which nobody needs.
    _exit(0);
}
