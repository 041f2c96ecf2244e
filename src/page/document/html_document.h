#pragma once

#include <filesystem>
#include <string>

namespace aoscore {

/// The parts of one HTML file that needs no other files.
struct HtmlDocument {
    std::string title;  ///< follows "aoscore: "
    std::string style;
    std::string script;  ///< runs after the body; without one no script may run at all
    std::string body;    ///< HTML
};

/// Makes the file's text from reports/page/document.html.
std::string html_text(const HtmlDocument& document);

}  // namespace aoscore
