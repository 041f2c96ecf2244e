#include "core/source_reference.h"

#include "core/error.h"

#include <fmt/format.h>

namespace aoscore {

std::string source_reference(StrictObject source) {
    const bool in_repository = source.has("repository");
    const std::string who = source.text(in_repository ? "repository" : "author");
    const std::string what = source.text(in_repository ? "document" : "title");
    if (source.has("year") == source.has("version"))
        throw file_error("has both or neither of them", source.where(),
                         "year, or version where there is none");
    const std::string when =
        source.has("year") ? fmt::format("{}", source.integer("year", 1900, 2100)) : source.text("version");
    std::string line = fmt::format("{}, {}, {}", who, what, when);
    if (source.has("place")) line += ", " + source.text("place");
    source.finish();
    return line;
}

}  // namespace aoscore
