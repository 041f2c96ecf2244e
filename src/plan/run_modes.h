#pragma once

#include "screen/screen.h"

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// The modes of a run: those choices of MethodRequest that apply to every method alike.
struct RunModes {
    Border border = Border::far;
    Normals normals = Normals::as_described;
    Resolution resolution = Resolution::full;
    Precision precision = Precision::full;
    GuardBand guard_band;
    bool operator==(const RunModes&) const = default;

    void apply_to(MethodRequest& request) const;
};

/// A mode as the command line and the results name it.
struct RunModeOption {
    std::string_view id;  ///< "resolution"
    std::string_view meaning;
    std::vector<std::string> choices;  ///< the usual one first; of a width, examples
    /// Sets the mode. Throws usage_error for what is no choice.
    std::function<void(RunModes&, const std::string& choice)> choose;
    std::function<std::string(const RunModes&)> chosen;
};
/// The one table of modes.
const std::vector<RunModeOption>& run_mode_options();

/// Sets a mode as a file says. Throws file_error for what is no choice; `where` names the place.
void choose_as_file_says(const RunModeOption& mode, RunModes& modes, const std::string& choice,
                         const std::string& where);

/// The modes that are not the usual ones, by id.
std::map<std::string, std::string> unusual_modes(const RunModes& modes);

}  // namespace aoscore
