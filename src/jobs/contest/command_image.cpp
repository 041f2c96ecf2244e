#include "jobs/contest/command_image.h"

#include "core/error.h"
#include "core/files.h"
#include "core/hash.h"
#include "core/printable.h"
#include "core/processes/bounded_command.h"
#include "core/temporary_folder.h"
#include "jobs/contest/command_request.h"

#include <fmt/format.h>

#include <utility>

namespace aoscore {
namespace {

namespace fs = std::filesystem;

/// The last line of what a command printed.
std::string last_line(std::string said) {
    while (!said.empty() && (said.back() == '\n' || said.back() == ' ')) said.pop_back();
    const auto line = said.rfind('\n');
    return printable(line == std::string::npos ? said : said.substr(line + 1));
}

void require_success(const CommandEnd& end, double timeout_s, const std::string& where) {
    if (end.ok()) return;
    const std::string said = end.said.empty() ? "" : ": " + last_line(end.said);
    if (end.timed_out)
        throw file_error(fmt::format("did not end within {:g} s, and was ended{}", timeout_s, said), where,
                         "a command that is quicker, or a larger timeout_s");
    throw file_error(end.signal != 0 ? fmt::format("was ended by signal {}{}", end.signal, said)
                                     : fmt::format("ended with {}{}", end.exit_code, said),
                     where, "a command that ends with 0");
}

class CommandImage final : public Contestant {
  public:
    CommandImage(const OutsideMethod& outside, CommandRun run) : outside_(outside), run_(std::move(run)) {}

    std::string_view code() const override { return "command_image"; }

    std::string digest(bool) const override {
        const OutsideCommand& command = *outside_.command;
        const VisibilityReading& reading = outside_.reading;
        Digest digest;
        digest.text(reading.channel).value(reading.coding == Coding::srgb).value(reading.invert);
        for (const std::string& word : command.words) digest.text(word);
        for (const fs::path& file : command.files)
            digest.text(file.filename().string()).text(read_file(file));
        digest.text(command.version).text(command.output).value(run_.radius_m).value(run_.seed);
        for (const auto& [id, value] : command.presets.at(run_.preset)) digest.text(id).text(value.text());
        return digest.hex();
    }

    // The key of its image holds scene, camera and size by that of a G-buffer, whether it reads one or not.
    std::optional<std::set<std::string>> gbuffer_inputs() const override {
        if (!outside_.command->needs_gbuffer) return std::set<std::string>{};
        return std::set<std::string>{"linear_depth", "hardware_depth", "normal_geometric", "normal_smooth"};
    }

    ContestantImage image(const ContestantSources& sources) const override {
        const OutsideCommand& command = *outside_.command;
        const std::string where = (outside_.folder / "contestant.json").string() + ": command";
        const TemporaryFolder folder;
        const std::vector<std::string> words = write_command_request(outside_, run_, sources, folder.path());
        require_success(run_bounded(words, folder.path(), command.timeout_s), command.timeout_s, where);
        const fs::path file = folder.path() / command.output;
        if (!fs::exists(file))
            throw file_error("ended well, and wrote no " + command.output, where,
                             "an image at {output}, as the request names it");
        const ImageF image =
            read_outside_image(file, outside_.reading, sources.frame.width(), sources.frame.height());
        return {{image, image, {}, {}}, read_reported_cost(folder.path())};
    }

  private:
    const OutsideMethod& outside_;
    CommandRun run_;
};

}  // namespace

std::shared_ptr<const Contestant> command_image(const OutsideMethod& outside, CommandRun run) {
    return std::make_shared<CommandImage>(outside, std::move(run));
}

}  // namespace aoscore
