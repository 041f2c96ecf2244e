#include "screen/shader_source.h"

#include "core/error.h"
#include "core/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <regex>
#include <sstream>

namespace aoscore {
namespace fs = std::filesystem;

namespace {

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
    const fs::path shaders = home_dir() / "shaders";
    for (const fs::path& candidate : {folder / name, shaders / name}) {
        if (fs::is_regular_file(candidate)) return fs::weakly_canonical(candidate);
    }
    throw file_error(fmt::format("includes \"{}\", which is not there", name), where,
                     fmt::format("a file in {} or {}", folder.string(), shaders.string()));
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

void ShaderSource::begin_part(std::size_t part, std::size_t line) {
    text_ += fmt::format("#line {} {}\n", line, part);
}

void ShaderSource::add_block(std::string name, std::string_view text) {
    const std::size_t part = add_part(std::move(name), text);
    begin_part(part, 1);
    for (const std::string& line : parts_[part].lines) text_ += line + "\n";
}

void ShaderSource::add_file(const fs::path& file, const fs::path& folder) {
    if (!entered_.insert(fs::weakly_canonical(file)).second) return;
    const std::size_t part = add_part(file.string(), read_file(file, std::size_t{4} << 20));
    begin_part(part, 1);
    static const std::regex include(R"rx(^\s*#\s*include\s+"([^"]+)"\s*(//.*)?$)rx");
    const std::vector<std::string> lines = parts_[part].lines;  // a copy: parts_ grows below
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::smatch match;
        if (std::regex_match(lines[i], match, include)) {
            add_file(find_include(match[1], folder, fmt::format("{}:{}", file.string(), i + 1)), folder);
            begin_part(part, i + 2);
        } else {
            text_ += lines[i] + "\n";
        }
    }
}

std::string ShaderSource::explain(std::string_view log) const {
    static const std::regex place(R"((\d+):(\d+)\((\d+)\):?)");
    constexpr std::size_t kContextLines = 2;
    std::string result;
    for (const std::string& message : lines_of(log)) {
        std::smatch match;
        const bool placed = std::regex_search(message, match, place);
        const std::size_t part = placed ? std::stoul(match[1]) : parts_.size();
        if (part >= parts_.size()) {
            result += message + "\n";
            continue;
        }
        const std::size_t line = std::stoul(match[2]);
        result += fmt::format("{}:{}:{}{}\n", parts_[part].name, line, match[3].str(), match.suffix().str());
        const auto& lines = parts_[part].lines;
        const std::size_t first = line > kContextLines ? line - kContextLines : 1;
        for (std::size_t i = first; i <= std::min(line + kContextLines, lines.size()); ++i) {
            result += fmt::format("{} {:4} | {}\n", i == line ? ">" : " ", i, lines[i - 1]);
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
