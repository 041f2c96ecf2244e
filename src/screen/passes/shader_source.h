#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace aoscore {

/// The text of one shader, assembled from files and generated blocks. Every part keeps its name and its
/// own line numbers, so that a compiler's message can be shown beside the line that it means.
class ShaderSource {
  public:
    /// Begins the text with `#version 330 core`.
    ShaderSource();

    /// From here on, loops that follow a line `#pragma unroll` and count from 0 to one of these names are
    /// written out, up to kMostUnrolled times: constants of a table then stand in the code itself, which no
    /// compiler here does for long loops. Such a loop has no `break` or `continue`.
    void unroll(std::map<std::string, int> counts) { loop_counts_ = std::move(counts); }
    static constexpr int kMostUnrolled = 64;

    /// Appends generated text under a name for messages, such as "(parameters)".
    void add_block(std::string name, std::string_view text);

    /// Appends a file with its includes. `#include "lib/noise.glsl"` is looked for in `folder` first, then in
    /// the program's shaders/, unless generated_include() knows it; each enters once. Throws file_error for
    /// one that is missing.
    void add_file(const std::filesystem::path& file, const std::filesystem::path& folder);

    const std::string& text() const { return text_; }

    /// A compiler's log with each line number turned into the part's name and its own line, and the numbered
    /// lines around it. (`#line` would do, but Mesa forgets its source number in half of its messages.)
    std::string explain(std::string_view log) const;

  private:
    struct Part {
        std::string name;
        std::vector<std::string> lines;
    };
    struct Origin {
        std::size_t part = 0;
        std::size_t line = 0;  // counted from 1
    };
    void add_include(const std::string& name, const std::filesystem::path& folder, const std::string& where);
    std::size_t add_part(std::string name, std::string_view text);
    void add_line(std::size_t part, std::size_t index);
    void add_text(const std::string& line, Origin origin);
    std::size_t add_unrolled(std::size_t part, std::size_t index);

    std::string text_;
    std::map<std::string, int> loop_counts_;
    std::vector<Part> parts_;
    std::vector<Origin> origins_;  // origin of each line of text_ after the first
    std::set<std::filesystem::path> entered_;
};

/// The file's text with all its includes, for checks that only look at words.
std::string expanded_text(const std::filesystem::path& file, const std::filesystem::path& folder);

/// True when `word` stands in `text` as a whole GLSL identifier, outside of comments.
bool mentions(std::string_view text, std::string_view word);

}  // namespace aoscore
