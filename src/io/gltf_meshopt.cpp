// EXT_meshopt_compression through libmeshoptimizer; without it, an error that says so.
#include "io/gltf_meshopt.hpp"

#include "parallel/big_memory.hpp"

#ifdef LUSTRO_HAS_MESHOPT
#include <meshoptimizer.h>
#endif

namespace lustro {

#ifdef LUSTRO_HAS_MESHOPT

Result<FileBytes> unpack_meshopt(std::string_view bytes, const GltfMeshopt& packed) {
  FileBytes result;
  result.size = packed.count * packed.stride;
  result.data = make_big_array<char>(result.size);
  const auto* from = reinterpret_cast<const unsigned char*>(bytes.data());
  int error = 0;
  switch (packed.mode) {
    case GltfMeshopt::Mode::attributes:
      error = meshopt_decodeVertexBuffer(result.data.get(), packed.count, packed.stride, from, bytes.size());
      break;
    case GltfMeshopt::Mode::triangles:
      error = meshopt_decodeIndexBuffer(result.data.get(), packed.count, packed.stride, from, bytes.size());
      break;
    case GltfMeshopt::Mode::indices:
      error = meshopt_decodeIndexSequence(result.data.get(), packed.count, packed.stride, from, bytes.size());
  }
  if (error != 0) {
    return fail(ErrorKind::malformed, {}, "its bytes cannot be unpacked");
  }
  undo_meshopt_filter(result.data.get(), packed);
  return result;
}

#else

Result<FileBytes> unpack_meshopt(std::string_view, const GltfMeshopt&) {
  return fail(ErrorKind::unsupported, {}, "EXT_meshopt_compression is not read: this build of Lustro is without libmeshoptimizer");
}

#endif

}  // namespace lustro
