#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace aoscore::gltf {

bool is_data_uri(std::string_view uri);

/// The bytes of a base64 data URI ("data:[type];base64,…"); any media type. Throws file_error at `where` for
/// another coding and for broken base64 (The Base16, Base32, and Base64 Data Encodings, Josefsson 2006).
std::string decode_data_uri(std::string_view uri, const std::string& where);

/// Turns a relative URI into a path below the asset's folder, percent-encoding undone. Throws file_error at
/// `where` when it is empty, has a scheme, is absolute, steps out of the folder (even to come back), or holds
/// a backslash or a control character. Opens nothing.
std::filesystem::path check_relative_uri(std::string_view uri, const std::string& where);

/// The files a glTF file may refer to: those in its own folder and below, never one reached by a symbolic
/// link that leads outside.
class AssetFolder {
  public:
    explicit AssetFolder(const std::filesystem::path& gltf_file);

    /// The content of a file named by a relative URI. Throws file_error at `where`.
    std::string read(std::string_view uri, const std::string& where) const;

  private:
    std::filesystem::path folder_;
};

}  // namespace aoscore::gltf
