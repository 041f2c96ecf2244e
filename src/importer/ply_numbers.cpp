#include "importer/ply_numbers.h"

#include "core/error.h"
#include "scene/gltf/place.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

namespace aoscore::importer {
namespace {

constexpr std::string_view kPlyBlank = " \t\r\n\f\v";

/// The number that these little-endian bytes stand for.
template <class T>
double value_of(const char* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<double>(value);
}

}  // namespace

void PlyNumbers::fail(const char* what, const char* valid) const {
    throw file_error(what, fmt::format("{} {}", gltf::printable(std::string(element_)), row_ + 1), valid);
}

std::string_view PlyNumbers::next_word() {
    const std::size_t first = content_.find_first_not_of(kPlyBlank, at_);
    if (first == content_.npos) fail("is missing: the file ends before it", "as many as its header states");
    at_ = std::min(content_.size(), content_.find_first_of(kPlyBlank, first));
    return content_.substr(first, at_ - first);
}

double PlyNumbers::next_binary(PlyNumber type) {
    const std::size_t size = size_of(type);
    if (content_.size() - at_ < size)
        fail("is missing: the file ends before it", "as many as its header states");
    char bytes[8];
    std::memcpy(bytes, content_.data() + at_, size);
    at_ += size;
    if (encoding_ == PlyHeader::Encoding::big_endian) std::reverse(bytes, bytes + size);
    switch (type) {
        case PlyNumber::int8:
            return value_of<std::int8_t>(bytes);
        case PlyNumber::uint8:
            return value_of<std::uint8_t>(bytes);
        case PlyNumber::int16:
            return value_of<std::int16_t>(bytes);
        case PlyNumber::uint16:
            return value_of<std::uint16_t>(bytes);
        case PlyNumber::int32:
            return value_of<std::int32_t>(bytes);
        case PlyNumber::uint32:
            return value_of<std::uint32_t>(bytes);
        case PlyNumber::float32:
            return value_of<float>(bytes);
        default:
            return value_of<double>(bytes);
    }
}

double PlyNumbers::next(PlyNumber type) {
    if (encoding_ != PlyHeader::Encoding::text) return next_binary(type);
    std::string_view word = next_word();
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || stop != word.data() + word.size()) fail("holds what is no number", "numbers");
    return value;
}

std::uint64_t PlyNumbers::next_count(PlyNumber type) {
    const double count = next(type);
    // Every number of a list takes a byte at least.
    if (!(count >= 0 && count <= static_cast<double>(content_.size()) && count == std::floor(count)))
        fail("has a list whose length is wrong or exceeds the file", "as many numbers as the list states");
    return static_cast<std::uint64_t>(count);
}

void PlyNumbers::skip(PlyNumber type, std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) next(type);
}

bool PlyNumbers::at_end() const {
    return content_.find_first_not_of(kPlyBlank, at_) == content_.npos;
}

}  // namespace aoscore::importer
