#include "scene/gltf/asset_folder.h"

#include "core/error.h"
#include "core/files.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <system_error>

namespace aoscore::gltf {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxFileBytes = std::size_t{1} << 30;
constexpr const char* kValidUri = "a relative path within the file's folder";

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

std::string undo_percent_encoding(std::string_view uri) {
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const int high = i + 2 < uri.size() ? hex_digit(uri[i + 1]) : -1;
        const int low = i + 2 < uri.size() ? hex_digit(uri[i + 2]) : -1;
        if (uri[i] == '%' && high >= 0 && low >= 0) {
            text += static_cast<char>(high * 16 + low);
            i += 2;
        } else {
            text += uri[i];
        }
    }
    return text;
}

/// Whether a URI begins with a scheme such as "https:" or a drive such as "C:" (the generic syntax of URIs).
bool has_scheme(std::string_view uri) {
    const std::size_t colon = uri.find(':');
    if (colon == std::string_view::npos || colon == 0) return false;
    const std::string_view scheme = uri.substr(0, colon);
    return std::all_of(scheme.begin(), scheme.end(), [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+' || c == '-' || c == '.';
    });
}

int base64_digit(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    if (c == '+') return 62;
    if (c == '/') return 63;
    return -1;
}

}  // namespace

bool is_data_uri(std::string_view uri) {
    return uri.starts_with("data:");
}

std::string decode_data_uri(std::string_view uri, const std::string& where) {
    constexpr std::string_view kMarker = ";base64,";
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos || !uri.substr(0, comma + 1).ends_with(kMarker)) {
        throw file_error("is a data URI that is not base64", where, "data:…;base64,…");
    }
    std::string_view digits = uri.substr(comma + 1);
    if (digits.size() % 4 == 0 && digits.ends_with('=')) digits.remove_suffix(digits.ends_with("==") ? 2 : 1);

    std::string bytes;
    bytes.reserve(digits.size() / 4 * 3 + 3);
    unsigned pending = 0;
    int pending_bits = 0;
    for (const char c : digits) {
        const int digit = base64_digit(c);
        if (digit < 0) throw file_error("is broken base64", where);
        pending = (pending << 6) | static_cast<unsigned>(digit);
        pending_bits += 6;
        if (pending_bits >= 8) {
            pending_bits -= 8;
            bytes += static_cast<char>((pending >> pending_bits) & 0xFFu);
        }
    }
    if (digits.size() % 4 == 1) throw file_error("is broken base64", where);
    return bytes;
}

fs::path check_relative_uri(std::string_view uri, const std::string& where) {
    if (uri.empty()) throw file_error("is empty", where, kValidUri);
    if (has_scheme(uri)) throw file_error("has a scheme or a drive", where, kValidUri);
    const std::string text = undo_percent_encoding(uri);
    if (text.find('\\') != std::string::npos) throw file_error("holds a backslash", where, kValidUri);
    if (std::any_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 32; })) {
        throw file_error("holds a control character", where, kValidUri);
    }
    const fs::path path(text);
    if (path.is_absolute()) throw file_error("is an absolute path", where, kValidUri);
    int depth = 0;
    for (const fs::path& part : path) {
        if (part == "..")
            --depth;
        else if (part != "." && !part.empty())
            ++depth;
        if (depth < 0) throw file_error("leaves the file's folder", where, kValidUri);
    }
    return path;
}

AssetFolder::AssetFolder(const fs::path& gltf_file)
    : folder_(fs::weakly_canonical(fs::absolute(gltf_file).parent_path())) {}

std::string AssetFolder::read(std::string_view uri, const std::string& where) const {
    const fs::path relative = check_relative_uri(uri, where);
    std::error_code ec;
    const fs::path file = fs::canonical(folder_ / relative, ec);
    if (ec) throw file_error("names a file that is not there", where);
    const auto [end_of_folder, rest] =
        std::mismatch(folder_.begin(), folder_.end(), file.begin(), file.end());
    if (end_of_folder != folder_.end() || rest == file.end()) {
        throw file_error("leaves the file's folder by a symbolic link", where, kValidUri);
    }
    if (!fs::is_regular_file(file, ec)) throw file_error("names no regular file", where);
    try {
        return read_file(file, kMaxFileBytes);
    } catch (const Error&) {
        throw file_error("names a file that cannot be read or is too large", where);
    }
}

}  // namespace aoscore::gltf
