#include "page/document/page_parts.h"

#include "core/error.h"
#include "core/files.h"
#include "core/folders.h"
#include "page/section.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace aoscore {
namespace {

namespace fs = std::filesystem;

/// The files of an npm package that are put into the page.
struct Library {
    const char* package;
    const char* script;
    const char* style;  ///< empty: the page's own styles suffice
};
constexpr std::array kLibraries = {
    Library{"uplot", "dist/uPlot.iife.min.js", "dist/uPlot.min.css"},
    Library{"sortable-tablesort", "dist/sortable.min.js", ""},
};

std::string library_file(const Library& library, const char* file) {
    const fs::path path = data_dir() / "node_modules" / library.package / file;
    if (!fs::exists(path)) {
        throw file_error(std::string("the page's library ") + library.package + " is not installed",
                         path.string(), "./run.sh installs it, or npm ci in the folder of package.json");
    }
    return read_file(path);
}

std::vector<fs::path> files_by_name(const fs::path& folder, const char* extension) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == extension) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// The comment with the licence, which must accompany the code.
std::string licence_comment(const Library& library) {
    return "/* " + std::string(library.package) + "\n" + library_file(library, "LICENSE") + "*/\n";
}

}  // namespace

fs::path page_folder() {
    return data_dir() / "reports" / "page";
}

std::string template_text(const fs::path& file) {
    constexpr std::string_view kBegin = "{{>", kEnd = "}}";
    std::string text = read_file(file);
    for (auto begin = text.find(kBegin); begin != std::string::npos; begin = text.find(kBegin, begin)) {
        const auto end = text.find(kEnd, begin);
        if (end == std::string::npos) break;  // which the template's own parser reports
        const std::string name = text.substr(begin + kBegin.size(), end - begin - kBegin.size());
        text.replace(begin, end + kEnd.size() - begin,
                     read_file(page_folder() / "partials" / (name + ".html")));
    }
    return text;
}

std::string page_style() {
    std::string style;
    for (const Library& library : kLibraries) {
        if (*library.style != '\0') style += library_file(library, library.style) + "\n";
    }
    for (const fs::path& file : files_by_name(page_folder() / "style", ".css")) style += read_file(file);
    return style;
}

std::string page_script() {
    std::string script;
    for (const Library& library : kLibraries) {
        script += licence_comment(library) + library_file(library, library.script) + "\n";
    }
    std::string own;
    for (const fs::path& file : files_by_name(page_folder() / "scripts", ".js")) own += read_file(file);
    for (const Section& section : sections()) {
        const fs::path file = page_folder() / "sections" / (std::string(section.id) + ".js");
        if (fs::exists(file)) own += "{\n" + read_file(file) + "}\n";
    }
    return script + closed_script(own);
}

std::string page_scripts(const std::vector<std::string>& names) {
    std::string scripts;
    for (const std::string& name : names) scripts += read_file(page_folder() / "scripts" / name);
    return scripts;
}

std::string closed_script(const std::string& scripts) {
    return "(() => {\n'use strict';\n" + scripts + "})();\n";
}

}  // namespace aoscore
