// See gltf_mesh.hpp. Positions, normals and tangents are moved in double and rounded once.
#include "io/gltf_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "image/srgb.hpp"
#include "io/gltf_accessor.hpp"
#include "io/gltf_draco.hpp"
#include "io/limits.hpp"

namespace lustro {
namespace {

constexpr std::uint32_t kNone = SourceMesh::kNone;

/// What moves directions: the rows of a matrix's linear part, and its cofactors, which are the inverse transpose times the determinant.
struct Linear {
  std::array<Vec3d, 3> rows;
  std::array<Vec3d, 3> cofactors;
  double determinant = 0;

  explicit Linear(const Mat4& m) : rows{Vec3d{m(0, 0), m(0, 1), m(0, 2)}, Vec3d{m(1, 0), m(1, 1), m(1, 2)}, Vec3d{m(2, 0), m(2, 1), m(2, 2)}} {
    cofactors = {cross(rows[1], rows[2]), cross(rows[2], rows[0]), cross(rows[0], rows[1])};
    determinant = dot(rows[0], cofactors[0]);
    if (determinant < 0) {
      cofactors = {-cofactors[0], -cofactors[1], -cofactors[2]};
    }
  }

  [[nodiscard]] Vec3d normal(const Vec3d& n) const { return unit({dot(cofactors[0], n), dot(cofactors[1], n), dot(cofactors[2], n)}); }
  [[nodiscard]] Vec3d tangent(const Vec3d& t) const { return unit({dot(rows[0], t), dot(rows[1], t), dot(rows[2], t)}); }

  /// v / |v|; what has no direction stays as it is.
  static Vec3d unit(const Vec3d& v) {
    const double size = length(v);
    return size > 0 && std::isfinite(size) ? Vec3d{v.x / size, v.y / size, v.z / size} : v;
  }
};

Vec3d triple(const std::vector<double>& list, std::size_t i) {
  return {list[3 * i], list[3 * i + 1], list[3 * i + 2]};
}

void set_triple(std::vector<double>& list, std::size_t i, const Vec3d& v) {
  list[3 * i] = v.x;
  list[3 * i + 1] = v.y;
  list[3 * i + 2] = v.z;
}

Vec3f rounded(const Vec3d& v) {
  return vec_cast<float>(v);
}

std::vector<double> widened(const std::vector<float>& list) {
  return {list.begin(), list.end()};
}

/// Appends `from` behind `base` elements, or as many defaults where a stream that others have is missing.
template <class T>
void append_stream(std::vector<T>& to, std::vector<T>&& from, std::size_t base, std::size_t count, const T& absent) {
  if (from.empty() && to.empty()) {
    return;
  }
  to.resize(base, absent);
  if (from.empty()) {
    to.resize(base + count, absent);
  } else {
    to.insert(to.end(), from.begin(), from.end());
  }
}

}  // namespace

bool is_drawn(const GltfPrimitive& primitive) {
  return primitive.mode >= GltfMode::triangles && primitive.attributes.position != kGltfNone;
}

GltfMaterial material_of(const GltfDocument& document, const GltfMaterialUse& use) {
  GltfMaterial material;
  material.name = "default";
  material = use.material == kGltfNone ? material : document.materials[use.material];
  if (use.is_colored) {
    material.metallic = 0;
  }
  return material;
}

/// Vertices of one primitive on their way.
struct GltfMeshBuilder::Vertices {
  std::size_t count = 0;
  std::vector<double> positions, normals, tangents;  ///< count x 3; the last two or empty
  std::vector<float> handedness;                     ///< count or empty: the sign of the bitangent
  std::array<std::vector<float>, 2> uvs;             ///< count x 2 or empty
  std::vector<float> colors;                         ///< count x color_parts or empty, linear
  std::size_t color_parts = 3;
  std::vector<std::uint32_t> packed_indices;  ///< of a Draco mesh
  std::vector<std::vector<float>> packed_joints, packed_weights;

  void move(const Mat4& matrix) {
    const Linear linear(matrix);
    for (std::size_t i = 0; i < count; ++i) {
      set_triple(positions, i, transform_point(matrix, triple(positions, i)));
      if (!normals.empty()) {
        set_triple(normals, i, linear.normal(triple(normals, i)));
      }
      if (!tangents.empty()) {
        set_triple(tangents, i, linear.tangent(triple(tangents, i)));
        handedness[i] = linear.determinant < 0 ? -handedness[i] : handedness[i];
      }
    }
  }
};

Result<void> GltfMeshBuilder::unpack(const GltfPrimitive& primitive, const std::string& path, Vertices& vertices) {
  const GltfAttributes& a = primitive.attributes;
  const std::string place = path + ".extensions.KHR_draco_mesh_compression";
  std::vector<DracoWish> wishes;
  for (const GltfDraco::Attribute& attribute : primitive.draco->attributes) {
    const GltfAccessor& stated = file_.document.accessors[attribute.accessor];
    wishes.push_back({attribute.name, attribute.id, stated.components(), stated.is_normalized});
  }
  Result<DracoMesh> mesh = unpack_draco(file_.views[primitive.draco->view], wishes, file_.values_left);
  if (!mesh) {
    return file_.fail_at(mesh.error().where.empty() ? place : place + ".attributes." + mesh.error().where, mesh.error().message,
                         mesh.error().kind);
  }
  std::uint64_t values = mesh->indices.size();
  for (std::size_t i = 0; i < wishes.size(); ++i) {
    const std::uint32_t accessor = primitive.draco->attributes[i].accessor;
    if (file_.document.accessors[accessor].count != mesh->points) {
      return file_.fail_at(
          place, fmt::format("holds {} points, and accessors[{}] states {}", mesh->points, accessor, file_.document.accessors[accessor].count));
    }
    values += mesh->values[i].size();
  }
  if (primitive.indices != kGltfNone && file_.document.accessors[primitive.indices].count != mesh->indices.size() &&
      primitive.mode == GltfMode::triangles) {
    return file_.fail_at(place, fmt::format("holds {} corners, and accessors[{}] states {}", mesh->indices.size(), primitive.indices,
                                            file_.document.accessors[primitive.indices].count));
  }
  if (const Result<void> taken = file_.take(values, place); !taken) {
    return taken;
  }
  const auto packed = [&](std::uint32_t accessor) -> std::vector<float> {
    for (std::size_t i = 0; accessor != kGltfNone && i < wishes.size(); ++i) {
      if (primitive.draco->attributes[i].accessor == accessor) {
        return mesh->values[i];
      }
    }
    return {};
  };
  vertices.packed_indices = std::move(mesh->indices);
  vertices.positions = widened(packed(a.position));
  vertices.normals = widened(packed(a.normal));
  if (const std::vector<float> tangents = packed(a.tangent); !tangents.empty()) {
    for (std::size_t i = 0; i < mesh->points; ++i) {
      vertices.tangents.insert(vertices.tangents.end(), tangents.begin() + static_cast<std::ptrdiff_t>(4 * i),
                               tangents.begin() + static_cast<std::ptrdiff_t>(4 * i + 3));
      vertices.handedness.push_back(tangents[4 * i + 3]);
    }
  }
  vertices.uvs = {packed(a.uvs[0]), packed(a.uvs[1])};
  vertices.colors = packed(a.color);
  for (std::size_t set = 0; set < a.joints.size(); ++set) {
    vertices.packed_joints.push_back(packed(a.joints[set]));
    vertices.packed_weights.push_back(packed(a.weights[set]));
  }
  return {};
}

Result<void> GltfMeshBuilder::read_vertices(const GltfPrimitive& primitive, const std::string& path, Vertices& vertices) {
  const GltfAttributes& a = primitive.attributes;
  vertices.count = static_cast<std::size_t>(file_.document.accessors[a.position].count);
  if (a.color != kGltfNone) {
    vertices.color_parts = file_.document.accessors[a.color].components();
  }
  if (primitive.draco) {
    if (const Result<void> done = unpack(primitive, path, vertices); !done) {
      return done;
    }
  }
  const auto read = [&](std::uint32_t accessor, auto& to, bool is_there) -> Result<void> {
    if (accessor == kGltfNone || is_there) {
      return {};
    }
    Result<std::vector<float>> values = read_floats(file_, accessor);
    if (!values) {
      return tl::unexpected(values.error());
    }
    to.assign(values->begin(), values->end());
    return {};
  };
  std::vector<float> tangents;
  const Result<void> done = read(a.position, vertices.positions, !vertices.positions.empty())
                                .and_then([&] { return read(a.normal, vertices.normals, !vertices.normals.empty()); })
                                .and_then([&] { return read(a.tangent, tangents, !vertices.tangents.empty() || a.normal == kGltfNone); })
                                .and_then([&] { return read(a.uvs[0], vertices.uvs[0], !vertices.uvs[0].empty()); })
                                .and_then([&] { return read(a.uvs[1], vertices.uvs[1], !vertices.uvs[1].empty()); })
                                .and_then([&] { return read(a.color, vertices.colors, !vertices.colors.empty()); });
  if (!done) {
    return done;
  }
  for (std::size_t i = 0; i < tangents.size(); i += 4) {
    vertices.tangents.insert(vertices.tangents.end(), tangents.begin() + static_cast<std::ptrdiff_t>(i),
                             tangents.begin() + static_cast<std::ptrdiff_t>(i + 3));
    vertices.handedness.push_back(tangents[i + 3]);
  }
  return {};
}

Result<void> GltfMeshBuilder::morph(const GltfPrimitive& primitive, const std::vector<double>& weights, Vertices& vertices) {
  for (std::size_t t = 0; t < std::min(primitive.targets.size(), weights.size()); ++t) {
    if (weights[t] == 0) {
      continue;
    }
    const GltfAttributes& target = primitive.targets[t];
    const auto add = [&](std::uint32_t accessor, std::vector<double>& to) -> Result<void> {
      return accessor == kGltfNone || to.empty() ? Result<void>() : add_weighted(file_, accessor, weights[t], to);
    };
    if (const Result<void> done =
            add(target.position, vertices.positions).and_then([&] { return add(target.normal, vertices.normals); }).and_then([&] {
              return add(target.tangent, vertices.tangents);
            });
        !done) {
      return done;
    }
  }
  return {};
}

Result<void> GltfMeshBuilder::skin(const GltfPrimitive& primitive, std::uint32_t index, Vertices& vertices) {
  const GltfSkin& skin = file_.document.skins[index];
  std::vector<Mat4> matrices;
  for (const std::uint32_t joint : skin.joints) {
    matrices.push_back(pose_.world[joint]);
  }
  if (skin.inverse_bind != kGltfNone) {
    const Result<std::vector<float>> inverse = read_floats(file_, skin.inverse_bind);
    if (!inverse) {
      return tl::unexpected(inverse.error());
    }
    for (std::size_t j = 0; j < matrices.size(); ++j) {
      Mat4 bind;
      for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) {
          bind(row, column) = static_cast<double>((*inverse)[16 * j + static_cast<std::size_t>(4 * column + row)]);
        }
      }
      matrices[j] = matrices[j] * bind;
    }
  }
  std::vector<Mat4> blended(vertices.count, Mat4{{}});
  std::vector<double> sums(vertices.count);
  for (std::size_t set = 0; set < primitive.attributes.joints.size(); ++set) {
    const auto values_of = [&](const std::vector<std::vector<float>>& packed, std::uint32_t accessor) -> Result<std::vector<float>> {
      return set < packed.size() && !packed[set].empty() ? packed[set] : read_floats(file_, accessor);
    };
    const Result<std::vector<float>> joints = values_of(vertices.packed_joints, primitive.attributes.joints[set]);
    if (!joints) {
      return tl::unexpected(joints.error());
    }
    const Result<std::vector<float>> weights = values_of(vertices.packed_weights, primitive.attributes.weights[set]);
    if (!weights) {
      return tl::unexpected(weights.error());
    }
    for (std::size_t i = 0; i < 4 * vertices.count; ++i) {
      const auto weight = static_cast<double>((*weights)[i]);
      if (weight == 0 || !std::isfinite(weight)) {
        continue;
      }
      const auto joint = static_cast<std::size_t>(std::max((*joints)[i], 0.0F));
      if (joint >= matrices.size()) {
        return file_.fail_at(fmt::format("accessors[{}]", primitive.attributes.joints[set]),
                             fmt::format("vertex {} names joint {}, outside 0..{} of skins[{}]", i / 4, joint, matrices.size() - 1, index));
      }
      Mat4& sum = blended[i / 4];
      for (std::size_t k = 0; k < 12; ++k) {
        sum.m[k] += weight * matrices[joint].m[k];
      }
      sums[i / 4] += weight;
    }
  }
  for (std::size_t i = 0; i < vertices.count; ++i) {
    Mat4 m = blended[i];
    for (std::size_t k = 0; k < 12; ++k) {
      m.m[k] = sums[i] != 0 ? m.m[k] / sums[i] : matrices.front().m[k];
    }
    m(3, 3) = 1;
    set_triple(vertices.positions, i, transform_point(m, triple(vertices.positions, i)));
    if (vertices.normals.empty()) {
      continue;
    }
    const Linear linear(m);
    set_triple(vertices.normals, i, linear.normal(triple(vertices.normals, i)));
    if (!vertices.tangents.empty()) {
      set_triple(vertices.tangents, i, linear.tangent(triple(vertices.tangents, i)));
    }
  }
  return {};
}

void GltfMeshBuilder::append(const Vertices& vertices) {
  const std::size_t base = mesh_.positions.size();
  const std::size_t count = vertices.count;
  const auto triples = [&](const std::vector<double>& list) {
    std::vector<Vec3f> result;
    for (std::size_t i = 0; i < list.size() / 3; ++i) {
      result.push_back(rounded(triple(list, i)));
    }
    return result;
  };
  const auto pairs = [](const std::vector<float>& list) {
    std::vector<Vec2f> result;
    for (std::size_t i = 0; i + 1 < list.size(); i += 2) {
      result.push_back({list[i], list[i + 1]});
    }
    return result;
  };
  std::vector<std::array<float, 4>> tangents;
  for (std::size_t i = 0; i < vertices.handedness.size(); ++i) {
    const Vec3f t = rounded(Linear::unit(triple(vertices.tangents, i)));
    const bool is_good = is_finite(t) && t != Vec3f{};
    tangents.push_back({is_good ? t.x : 1, is_good ? t.y : 0, is_good ? t.z : 0, vertices.handedness[i] < 0 ? -1.0F : 1.0F});
  }
  std::vector<Vec3f> colors;
  std::vector<float> alphas;
  const auto in_range = [](float x) {
    return x >= 0 ? std::min(x, 1.0F) : x < 0 ? 0.0F : 1.0F;
  };  // what is no number leaves the surface as it is
  for (std::size_t i = 0; i < vertices.colors.size(); i += vertices.color_parts) {
    const float* c = vertices.colors.data() + i;
    const auto encoded = [&](float x) { return in_range(srgb_encode(in_range(x))); };
    colors.push_back({encoded(c[0]), encoded(c[1]), encoded(c[2])});
    if (vertices.color_parts == 4) {
      alphas.push_back(in_range(c[3]));
    }
  }
  append_stream(mesh_.positions, triples(vertices.positions), base, count, {});
  append_stream(mesh_.normals, triples(vertices.normals), base, count, {});
  append_stream(mesh_.uvs, pairs(vertices.uvs[0]), base, count, {});
  append_stream(mesh_.uvs1, pairs(vertices.uvs[1]), base, count, {});
  append_stream(mesh_.tangents, std::move(tangents), base, count, {1, 0, 0, 1});
  append_stream(mesh_.colors, std::move(colors), base, count, {1, 1, 1});
  append_stream(mesh_.alphas, std::move(alphas), base, count, 1.0F);
}

std::uint32_t GltfMeshBuilder::place_of(const GltfMaterialUse& use) {
  const auto [found, is_new] = materials_.try_emplace(use, static_cast<std::uint32_t>(material_uses_.size()));
  if (is_new) {
    material_uses_.push_back(use);
  }
  return found->second;
}

Result<void> GltfMeshBuilder::add_faces(const GltfPrimitive& primitive, const std::string& path, const Placed& vertices, std::uint32_t object) {
  std::vector<std::uint32_t> corners = vertices.packed_indices;
  if (!primitive.draco && primitive.indices != kGltfNone) {
    Result<std::vector<std::uint32_t>> read = read_whole(file_, primitive.indices);
    if (!read) {
      return tl::unexpected(read.error());
    }
    corners = std::move(*read);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (corners[i] >= vertices.count) {
        return file_.fail_at(path + ".indices", fmt::format("element {} of accessors[{}] is {}, outside 0..{}", i, primitive.indices, corners[i],
                                                            vertices.count - 1));
      }
    }
  } else if (!primitive.draco) {
    corners.resize(vertices.count);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      corners[i] = static_cast<std::uint32_t>(i);
    }
  }
  const bool is_list = primitive.mode == GltfMode::triangles || primitive.draco.has_value();
  const std::size_t triangles = is_list ? corners.size() / 3 : corners.size() < 3 ? 0 : corners.size() - 2;
  if (const Result<void> taken = file_.take(3 * triangles, path); !taken) {
    return taken;
  }
  if (mesh_.corner_position.size() + 3 * triangles > kMostElements) {
    return file_.fail_at(path, fmt::format("the mesh has more than {} corners", kMostElements), ErrorKind::limit);
  }
  const std::uint32_t material = place_of({primitive.material, vertices.has_colors});
  const std::uint32_t smoothing = vertices.has_normals ? 1 : 0;
  has_flat_ = has_flat_ || (smoothing == 0 && triangles != 0);
  for (std::size_t t = 0; t < triangles; ++t) {
    // Strips turn round at every other triangle; fans begin behind their hub (specification, 3.7.2.1).
    std::array<std::size_t, 3> of{3 * t, 3 * t + 1, 3 * t + 2};
    if (!is_list && primitive.mode == GltfMode::triangle_strip) {
      of = {t, t + 1 + t % 2, t + 2 - t % 2};
    } else if (!is_list) {
      of = {t + 1, t + 2, 0};
    }
    if (vertices.is_mirrored) {
      std::swap(of[1], of[2]);
    }
    for (const std::size_t corner : of) {
      mesh_.corner_position.push_back(vertices.base + corners[corner]);
    }
    mesh_.face_begin.push_back(static_cast<std::uint32_t>(mesh_.corner_position.size()));
    mesh_.face_material.push_back(material);
    mesh_.face_smoothing.push_back(smoothing);
    if (object != kNone) {
      mesh_.face_object.push_back(object);
    }
  }
  return {};
}

Result<GltfMeshBuilder::Placed> GltfMeshBuilder::place(std::uint32_t node_index, const GltfPrimitive& primitive, const std::string& path,
                                                       const std::optional<Mat4>& placement) {
  const GltfNode& node = file_.document.nodes[node_index];
  Vertices vertices;
  if (const Result<void> done = read_vertices(primitive, path, vertices); !done) {
    return tl::unexpected(done.error());
  }
  if (mesh_.positions.size() + vertices.count > kMostElements) {
    return file_.fail_at(path, fmt::format("the mesh has more than {} vertices", kMostElements), ErrorKind::limit);
  }
  constexpr std::uint64_t kValuesOfVertex = 16;
  if (const Result<void> taken = file_.take(kValuesOfVertex * vertices.count, path); !taken) {
    return tl::unexpected(taken.error());
  }
  if (const Result<void> done = morph(primitive, pose_.weights[node_index], vertices); !done) {
    return tl::unexpected(done.error());
  }
  Placed placed{static_cast<std::uint32_t>(mesh_.positions.size()), static_cast<std::uint32_t>(vertices.count), !vertices.normals.empty(),
                !vertices.colors.empty()};
  if (node.skin != kGltfNone && !primitive.attributes.joints.empty()) {
    if (const Result<void> done = skin(primitive, node.skin, vertices); !done) {
      return tl::unexpected(done.error());
    }
  } else if (placement) {
    vertices.move(*placement);
    placed.is_mirrored = Linear(*placement).determinant < 0;
  }
  append(vertices);
  placed.packed_indices = std::move(vertices.packed_indices);
  return placed;
}

Result<void> GltfMeshBuilder::add_primitive(std::uint32_t node, const GltfPrimitive& primitive, const std::string& path,
                                            const std::optional<Mat4>& placement, std::uint32_t object, Shared& shared) {
  if (!is_drawn(primitive)) {
    return {};
  }
  std::vector<std::uint32_t> key;
  const auto add_key = [&](const GltfAttributes& a) {
    key.insert(key.end(), {a.position, a.normal, a.tangent, a.color, a.uvs[0], a.uvs[1]});
    key.insert(key.end(), a.joints.begin(), a.joints.end());
    key.insert(key.end(), a.weights.begin(), a.weights.end());
  };
  add_key(primitive.attributes);
  std::for_each(primitive.targets.begin(), primitive.targets.end(), add_key);
  if (const auto known = shared.find(key); known != shared.end() && !primitive.draco) {
    return add_faces(primitive, path, known->second, object);
  }
  const Result<Placed> placed = place(node, primitive, path, placement);
  if (!placed) {
    return tl::unexpected(placed.error());
  }
  if (!primitive.draco) {
    shared.emplace(std::move(key), *placed);
  }
  return add_faces(primitive, path, *placed, object);
}

Result<void> GltfMeshBuilder::add(std::uint32_t node, const std::optional<Mat4>& placement, std::uint32_t object) {
  const std::uint32_t mesh = file_.document.nodes[node].mesh;
  const std::vector<GltfPrimitive>& primitives = file_.document.meshes[mesh].primitives;
  Shared shared;
  for (std::size_t p = 0; p < primitives.size(); ++p) {
    const std::string path = fmt::format("meshes[{}].primitives[{}]", mesh, p);
    if (const Result<void> done = add_primitive(node, primitives[p], path, placement, object, shared); !done) {
      return done;
    }
  }
  return {};
}

SourceMesh GltfMeshBuilder::finish() {
  if (!mesh_.normals.empty()) {
    mesh_.corner_normal = mesh_.corner_position;
    for (std::size_t c = 0; has_flat_ && c < mesh_.corner_normal.size(); ++c) {
      mesh_.corner_normal[c] = mesh_.face_smoothing[c / 3] == 0 ? kNone : mesh_.corner_normal[c];
    }
  }
  if (!mesh_.uvs.empty()) {
    mesh_.corner_uv = mesh_.corner_position;
  }
  if (!has_flat_) {
    mesh_.face_smoothing = {};
  }
  mesh_.format = file_.is_binary ? "glTF (binary)" : "glTF";
  return std::move(mesh_);
}

}  // namespace lustro
