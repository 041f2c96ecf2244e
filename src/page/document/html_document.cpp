#include "page/document/html_document.h"

#include "core/files.h"
#include "page/document/page_parts.h"
#include "page/document/page_template.h"

namespace aoscore {

std::string html_text(const HtmlDocument& document) {
    const std::filesystem::path frame = page_folder() / "document.html";
    return fill_template(read_file(frame),
                         {{"title", document.title},
                          {"style", document.style},
                          {"script", document.script},
                          {"has_script", !document.script.empty()},
                          {"body", document.body}},
                         frame.string());
}

}  // namespace aoscore
