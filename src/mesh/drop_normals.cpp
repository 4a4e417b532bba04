// Vertices told apart by the bits of what they have left.
#include "mesh/drop_normals.hpp"

#include <bit>

#include "mesh/index_table.hpp"

namespace lustro {
namespace {

std::uint64_t bits(const Vec2f& v) {
  return std::uint64_t{value_bits(v.x)} << 32U | value_bits(v.y);
}

std::uint64_t hash_of(const Mesh& mesh, std::size_t v) {
  std::uint64_t hash = mix(0, mesh.positions[v]);
  // clang-format off
  if (!mesh.uvs.empty())    { hash = mix(hash, bits(mesh.uvs[v])); }
  if (!mesh.uvs1.empty())   { hash = mix(hash, bits(mesh.uvs1[v])); }
  if (!mesh.colors.empty()) { hash = mix(hash, mesh.colors[v]); }
  if (!mesh.alphas.empty()) { hash = mix(hash, value_bits(mesh.alphas[v])); }
  // clang-format on
  return hash;
}

template <class T>
bool same(const std::vector<T>& values, std::size_t a, std::size_t b) {
  return values.empty() || values[a] == values[b];
}

template <class T>
void keep(std::vector<T>& values, const std::vector<std::uint32_t>& kept) {
  if (values.empty()) {
    return;
  }
  std::vector<T> chosen;
  chosen.reserve(kept.size());
  for (const std::uint32_t v : kept) {
    chosen.push_back(values[v]);
  }
  values = std::move(chosen);
}

}  // namespace

void drop_normals(Mesh& mesh) {
  mesh.normals.clear();
  mesh.tangents.clear();
  std::vector<std::uint32_t> kept;  // old numbers by new ones
  IndexTable known(mesh.positions.size());
  for (auto& triangle : mesh.triangles) {
    for (std::uint32_t& corner : triangle) {
      const std::uint32_t v = corner;
      const auto fresh = static_cast<std::uint32_t>(kept.size());
      corner = known.find_or_insert(hash_of(mesh, v), fresh, [&](std::uint32_t n) {
        const std::uint32_t old = kept[n];
        return same(mesh.positions, old, v) && same(mesh.uvs, old, v) && same(mesh.uvs1, old, v) && same(mesh.colors, old, v) &&
               same(mesh.alphas, old, v);
      });
      if (corner == fresh) {
        kept.push_back(v);
      }
    }
  }
  keep(mesh.positions, kept);
  keep(mesh.uvs, kept);
  keep(mesh.uvs1, kept);
  keep(mesh.colors, kept);
  keep(mesh.alphas, kept);
}

}  // namespace lustro
