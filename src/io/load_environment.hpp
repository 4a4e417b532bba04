// The picture of a scene's environment.
#pragma once

#include <filesystem>

#include "lustro/scene.hpp"

namespace lustro {

/// Reads the picture from that very file: RGB, linear; gray becomes three equal channels, an alpha is left out.
/// transfer  how 8 and 16 bits are decoded
/// errors    io, malformed, unsupported, limit
[[nodiscard]] Result<std::shared_ptr<const Image>> read_environment(const std::filesystem::path& file, Transfer transfer);

/// Fills Environment::picture where a file is stated and the picture is not there yet. The file is found by find_texture() from `folder`, the
/// scene file's; what was overlooked to find it is a note.
/// options  transfer, on_file
/// errors   as above: without its environment a scene would be dark
[[nodiscard]] Result<Notes> load_environment(Environment& environment, const std::filesystem::path& folder, const LoadOptions& options);

}  // namespace lustro
