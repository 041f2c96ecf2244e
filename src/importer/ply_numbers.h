#pragma once

#include "importer/ply_header.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace aoscore::importer {

/// The numbers of a Stanford polygon file, one after the other.
class PlyNumbers {
  public:
    PlyNumbers(std::string_view content, const PlyHeader& header)
        : content_(content), at_(header.end), encoding_(header.encoding) {}

    /// Reads the next number. Throws file_error where the file ends, or a text holds something else.
    double next(PlyNumber type);
    /// Reads the next number as the length of a list.
    std::uint64_t next_count(PlyNumber type);
    void skip(PlyNumber type, std::uint64_t count);
    /// Whether nothing but blanks is left.
    bool at_end() const;

    /// Names the element that is read next for messages, such as vertex 7.
    void begin(std::string_view element, std::uint64_t row) {
        element_ = element;
        row_ = row;
    }

  private:
    [[noreturn]] void fail(const char* what, const char* valid) const;
    std::string_view next_word();
    double next_binary(PlyNumber type);

    std::string_view content_;
    std::size_t at_ = 0;
    PlyHeader::Encoding encoding_;
    std::string_view element_;
    std::uint64_t row_ = 0;
};

}  // namespace aoscore::importer
