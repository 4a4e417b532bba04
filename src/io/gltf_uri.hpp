// The URIs of a glTF file (RFC 3986, RFC 2397): data that stand in the URI itself, and files beside the document, never elsewhere.
#pragma once

#include <string>
#include <string_view>

#include "io/read_file.hpp"
#include "lustro/result.hpp"

namespace lustro {

[[nodiscard]] bool is_data_uri(std::string_view uri);

/// The bytes of `data:TYPE;base64,...` or `data:TYPE,percent-encoded`.
/// errors  malformed, without a place
[[nodiscard]] Result<FileBytes> decode_data_uri(std::string_view uri);

/// The file that a URI names, relative to the document's folder and never outside it: percent-encoding is undone, dots are resolved.
/// errors  malformed, without a place: an address with a scheme (http:), an absolute path, one that leaves the folder, a broken encoding
[[nodiscard]] Result<std::string> confined_path(std::string_view uri);

}  // namespace lustro
