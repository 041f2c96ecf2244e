#include "screen/trial/shader_trial.h"

#include "core/error.h"
#include "core/files.h"
#include "core/processes/child_process.h"
#include "core/processes/program_path.h"
#include "core/temporary_folder.h"

#include <csignal>

namespace aoscore {

namespace fs = std::filesystem;

void try_shader(const ShaderSource& vertex, const ShaderSource& fragment, const std::string& name) {
    const TemporaryFolder folder;
    const fs::path vertex_file = folder.path() / "vertex.glsl",
                   fragment_file = folder.path() / "fragment.glsl";
    fill_file(vertex_file, vertex.text(), vertex_file);
    fill_file(fragment_file, fragment.text(), fragment_file);
    ChildProcess trial(beside_program("aoscore-shader-trial"),
                       {vertex_file.string(), fragment_file.string()});
    for (char unused = 0; trial.read(&unused, 1) > 0;) {
    }
    const ChildProcess::End end = trial.wait();
    if (end.signal == SIGXCPU || end.signal == SIGKILL)
        throw file_error("takes more than 20 s of processor time to compile", name, "a smaller shader");
    if (end.signal != 0 || end.exit_code != 0)
        throw file_error("takes more than 2 GiB of memory to compile, or breaks the compiler", name,
                         "a smaller shader");
}

}  // namespace aoscore
