#include "core/source_reference.h"

#include <fmt/format.h>

namespace aoscore {

std::string source_reference(StrictObject source) {
    std::string line = fmt::format("{}, {}, {}", source.text("author"), source.text("title"),
                                   source.integer("year", 1900, 2100));
    if (source.has("place")) line += ", " + source.text("place");
    source.finish();
    return line;
}

}  // namespace aoscore
