#include "screen/passes/shader_source.h"

#include "core/error.h"
#include "core/files.h"
#include "screen/gbuffer/channel_glsl.h"
#include "screen/method/method_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <regex>
#include <sstream>

namespace aoscore {
namespace fs = std::filesystem;

namespace {

// The longest line that may be an include: std::regex recurses over matched text, and a longer line could
// overflow the stack.
constexpr std::size_t kLongestInclude = 4096;

std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> lines;
    std::istringstream stream{std::string(text)};
    for (std::string line; std::getline(stream, line);) {
        if (!line.empty() && line.back() == '\r') line.pop_back();
        lines.push_back(line);
    }
    return lines;
}

fs::path find_include(const std::string& name, const fs::path& folder, const std::string& where) {
    for (const fs::path& candidate : {folder / name, shader_library() / name}) {
        if (!fs::is_regular_file(candidate)) continue;
        require_own_file(candidate, folder, where);
        return fs::weakly_canonical(candidate);
    }
    throw file_error(fmt::format("includes \"{}\", which is not there", name), where,
                     fmt::format("a file in {} or {}", folder.string(), shader_library().string()));
}

// The text with comments replaced by blanks; line breaks stay.
std::string without_comments(std::string_view text) {
    std::string result(text);
    for (std::size_t i = 0; i + 1 < result.size(); ++i) {
        if (result[i] != '/') continue;
        if (result[i + 1] == '/') {
            while (i < result.size() && result[i] != '\n') result[i++] = ' ';
        } else if (result[i + 1] == '*') {
            const std::size_t end = std::min(result.find("*/", i + 2), result.size() - 2) + 2;
            for (; i < end; ++i) {
                if (result[i] != '\n') result[i] = ' ';
            }
        }
    }
    return result;
}

bool is_word_character(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

}  // namespace

ShaderSource::ShaderSource() : text_("#version 330 core\n") {}

std::size_t ShaderSource::add_part(std::string name, std::string_view text) {
    parts_.push_back({std::move(name), lines_of(text)});
    return parts_.size() - 1;
}

void ShaderSource::add_text(const std::string& line, Origin origin) {
    text_ += line + "\n";
    origins_.push_back(origin);
}

void ShaderSource::add_line(std::size_t part, std::size_t index) {
    add_text(parts_[part].lines[index], {part, index + 1});
}

// Writes out the loop that begins at this line, as often as it runs; returns the line after it, or `index`
// where the loop cannot be written out.
std::size_t ShaderSource::add_unrolled(std::size_t part, std::size_t index) {
    static const std::regex head(R"rx(^(\s*)for \(int (\w+) = 0; \2 < (\w+); \+\+\2\) \{$)rx");
    const std::vector<std::string>& lines = parts_[part].lines;
    std::smatch match;
    if (index >= lines.size() || !std::regex_match(lines[index], match, head)) return index;
    const auto count = loop_counts_.find(match[3]);
    if (count == loop_counts_.end() || count->second > kMostUnrolled) return index;
    std::size_t end = index + 1;
    while (end < lines.size() && lines[end] != match[1].str() + "}") ++end;
    if (end == lines.size()) return index;
    for (int i = 0; i < count->second; ++i) {
        add_text(fmt::format("{}{{ const int {} = {};", match[1].str(), match[2].str(), i),
                 {part, index + 1});
        for (std::size_t line = index + 1; line <= end; ++line) add_line(part, line);
    }
    return end + 1;
}

void ShaderSource::add_block(std::string name, std::string_view text) {
    const std::size_t part = add_part(std::move(name), text);
    for (std::size_t i = 0; i < parts_[part].lines.size(); ++i) add_line(part, i);
}

void ShaderSource::add_file(const fs::path& file, const fs::path& folder) {
    if (!entered_.insert(fs::weakly_canonical(file)).second) return;
    const std::size_t part = add_part(file.string(), read_file(file, std::size_t{4} << 20));
    static const std::regex include(R"rx(^\s*#\s*include\s+"([^"]+)"\s*(//.*)?$)rx");
    for (std::size_t i = 0; i < parts_[part].lines.size(); ++i) {
        std::smatch match;
        const std::string line = parts_[part].lines[i];  // a copy: parts_ grows below
        if (line.find("#pragma unroll") != std::string::npos) {
            const std::size_t next = add_unrolled(part, i + 1);
            if (next > i + 1) i = next - 1;
        } else if (line.size() <= kLongestInclude && std::regex_match(line, match, include)) {
            add_include(match[1], folder, fmt::format("{}:{}", file.string(), i + 1));
        } else {
            add_line(part, i);
        }
    }
}

void ShaderSource::add_include(const std::string& name, const fs::path& folder, const std::string& where) {
    const std::optional<std::string> generated = generated_include(name);
    if (!generated) return add_file(find_include(name, folder, where), folder);
    if (entered_.insert(name).second) add_block(fmt::format("({}, generated)", name), *generated);
}

std::string ShaderSource::explain(std::string_view log) const {
    static const std::regex place(R"(\d+:(\d{1,9})\((\d+)\):?)");
    constexpr std::size_t kLongestPlace = 64;
    constexpr std::size_t kContextLines = 2, kFirst = 2;  // the first line is #version's
    std::string result;
    for (const std::string& message : lines_of(log)) {
        std::smatch match;
        const std::string begin = message.substr(0, kLongestPlace);
        const std::size_t text_line = std::regex_search(begin, match, place) ? std::stoul(match[1]) : 0;
        if (text_line < kFirst || text_line - kFirst >= origins_.size()) {
            result += message + "\n";
            continue;
        }
        const Origin origin = origins_[text_line - kFirst];
        const Part& part = parts_[origin.part];
        result += fmt::format("{}:{}:{}{}\n", part.name, origin.line, match[2].str(),
                              message.substr(static_cast<std::size_t>(match.length() + match.position())));
        const std::size_t first = origin.line > kContextLines ? origin.line - kContextLines : 1;
        for (std::size_t i = first; i <= std::min(origin.line + kContextLines, part.lines.size()); ++i) {
            result += fmt::format("{} {:4} | {}\n", i == origin.line ? ">" : " ", i, part.lines[i - 1]);
        }
    }
    return result;
}

std::string expanded_text(const fs::path& file, const fs::path& folder) {
    ShaderSource source;
    source.add_file(file, folder);
    return source.text();
}

bool mentions(std::string_view text, std::string_view word) {
    const std::string code = without_comments(text);
    for (std::size_t at = code.find(word); at != std::string::npos; at = code.find(word, at + 1)) {
        const bool begins = at == 0 || !is_word_character(code[at - 1]);
        const std::size_t end = at + word.size();
        if (begins && (end == code.size() || !is_word_character(code[end]))) return true;
    }
    return false;
}

}  // namespace aoscore
