#pragma once

#include <filesystem>
#include <string>

namespace aoscore {

/// One HTML file that needs nothing beside it.
struct HtmlDocument {
    std::string title;  ///< behind "aoscore: "
    std::string style;
    std::string script;  ///< runs when all of the body is there; without one no script may run at all
    std::string body;    ///< HTML
};

/// The file's text: reports/page/document.html, filled.
std::string html_text(const HtmlDocument& document);

}  // namespace aoscore
