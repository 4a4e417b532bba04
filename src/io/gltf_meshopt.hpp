// EXT_meshopt_compression: views packed by Kapoulkine's codecs. The codecs are libmeshoptimizer's, where it is built in; the filters are ours,
// so that they have the same bits on every processor.
#pragma once

#include <string_view>

#include "io/gltf_document.hpp"
#include "io/read_file.hpp"
#include "lustro/result.hpp"

namespace lustro {

/// The view's bytes, packed.count * packed.stride.
/// errors  malformed; unsupported where the library is not built in. Without a place
[[nodiscard]] Result<FileBytes> unpack_meshopt(std::string_view bytes, const GltfMeshopt& packed);

/// Undoes a filter in place (appendix B of the extension).
void undo_meshopt_filter(char* elements, const GltfMeshopt& packed);

}  // namespace lustro
