#include "page/page.h"

#include "core/files.h"
#include "core/log.h"
#include "core/machine.h"
#include "page/document/html_document.h"
#include "page/document/page_key.h"
#include "page/document/page_parts.h"
#include "page/document/page_template.h"
#include "page/pictures/pictures.h"
#include "page/ranking_order.h"
#include "page/section.h"
#include "page/sections/cell_command.h"
#include "page/sections/stage_data.h"

#include <fmt/format.h>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// Beyond this size browsers open pages slowly, and mail programs refuse them.
constexpr std::size_t kLargePage_bytes = std::size_t{50} << 20;

std::string section_html(const Section& section, const nlohmann::json& content) {
    const fs::path fragment = page_folder() / "sections" / (std::string(section.id) + ".html");
    return fill_template(template_text(fragment), content, fragment.string());
}

/// Whether the rankings are all that there is to show, so that they are shown without pictures. Those of a
/// sweep or of claims would only mix their settings.
bool ranks_alone(const Results& all, const Results& pictured) {
    return pictured.views.empty() && all.sweeps.empty() && all.claims.empty();
}

const PageSource& source_of(const Section& section, const PageSource& all, const PageSource& pictured) {
    const bool whole = section.of == Section::Of::all ||
                       (section.of == Section::Of::ranked && ranks_alone(all.results, pictured.results));
    return whole ? all : pictured;
}

std::string page_html(const PageSource& all, const PageSource& source) {
    json model = {{"stage_data", stage_data(source)},
                  {"version", source.results.program_version},
                  {"created", source.results.created_utc},
                  {"sections", json::array()}};
    for (const Section& section : sections()) {
        const PageSource& used = source_of(section, all, source);
        if (section.applies != nullptr && !section.applies(used.results)) continue;
        json content = section.build(used);
        content["software"] = is_software_renderer(used.results.gl_renderer);
        content["pictured"] = !source.results.views.empty();
        model["sections"].push_back({{"id", std::string(section.id)},
                                     {"title", std::string(section.title)},
                                     {"folded", section.folded},
                                     {"in_short", content.value("in_short", "")},
                                     {"body", section_html(section, content)}});
    }
    const fs::path frame = page_folder() / "template.html";
    std::string html = html_text({"screen-space ambient occlusion against ray-traced truth", page_style(),
                                  page_script(), fill_template(read_file(frame), model, frame.string())});
    // The images come last, so that the top of the page does not wait for them.
    html.insert(html.rfind("</body>"),
                image_blocks(source) + live_blocks(source.live) + command_block(all.results));
    return html;
}

}  // namespace

void require_page_parts() {
    page_style();
    page_script();
}

fs::path write_page(const Results& of_run, const fs::path& results_folder, bool everything,
                    const std::string& key) {
    const Results results = in_ranking_order(of_run);
    const Results shown = pictured(results);
    LiveData live = read_live_data(shown, results_folder);
    const Pictures pictures =
        make_pictures(shown, results_folder, everything,
                      [&](const ViewRecord& view, const ImageFile& gbuffer, const fs::path& path) {
                          return add_gbuffer(live, view, gbuffer, path);
                      });
    std::string html = page_html({results, pictures, live}, {shown, pictures, live});
    if (html.size() > kLargePage_bytes) {
        log_warning(
            fmt::format("the page has {} MiB: render smaller images or fewer methods", html.size() >> 20U));
    }
    if (!key.empty()) html += page_key_comment(key);
    const fs::path path = results_folder / "index.html";
    write_atomically(path, html);
    return path;
}

fs::path write_page(const fs::path& results_folder) {
    return write_page(read_results(results_folder), results_folder);
}

void write_page_unless_shown(const fs::path& results_folder, const fs::path& shown, const std::string& code) {
    const Results results = read_results(results_folder);
    const std::string key = page_key(results, code);
    if (!is_page_of(shown, key)) write_page(results, results_folder, false, key);
}

}  // namespace aoscore
