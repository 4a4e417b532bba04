// KHR_draco_mesh_compression: a primitive's triangles and attributes packed by Google's codec, through libdraco where it is built in.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lustro/result.hpp"

namespace lustro {

/// An attribute that is wanted of a packed mesh.
struct DracoWish {
  std::string name;      ///< for messages
  std::uint32_t id = 0;  ///< its unique id within the packed mesh
  std::size_t components = 3;
  bool is_normalized = false;  ///< whole numbers stand for 0..1 or -1..1
};

struct DracoMesh {
  std::size_t points = 0;
  std::vector<std::uint32_t> indices;      ///< three a triangle, below `points`
  std::vector<std::vector<float>> values;  ///< one list a wish: points x components
};

/// most_values  of all lists together, indices included
/// errors  malformed, limit; unsupported where the library is not built in. `where` is the name of a wish, or empty
[[nodiscard]] Result<DracoMesh> unpack_draco(std::string_view bytes, std::span<const DracoWish> wishes, std::uint64_t most_values);

}  // namespace lustro
