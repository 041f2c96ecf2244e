#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace aoscore {

/// The folder of the page's template, style sheets, scripts and sections.
std::filesystem::path page_folder();

/// The text of a template, with reports/page/partials/NAME.html in the place of each {{>NAME}}. Throws
/// file_error where one is missing.
std::string template_text(const std::filesystem::path& file);

/// The style sheets of the libraries, then reports/page/style/*.css in the order of their names. Throws
/// file_error when a library is not installed.
std::string page_style();

/// The libraries' scripts, then the page's own in one strict scope: reports/page/scripts/*.js in the order of
/// their names, which hold declarations, then reports/page/sections/<id>.js of the sections that have one,
/// each in a block of its own, which run. Throws file_error when a library is not installed.
std::string page_script();

/// The page's scripts of these names, such as "columns.js", for another page.
std::string page_scripts(const std::vector<std::string>& names);
/// Scripts as one whose names others do not see.
std::string closed_script(const std::string& scripts);

}  // namespace aoscore
