// Checks run over all of a mesh, in parallel, once.
#include "scene/mesh_cache.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "image/srgb.hpp"
#include "mesh/displace.hpp"
#include "mesh/normals.hpp"
#include "parallel/slices.hpp"
#include "scene/displacement.hpp"

namespace lustro {
namespace {

// Whether `holds` is true of every index below `count`.
template <class Holds>
bool all_of(std::size_t count, int threads, Holds&& holds) {
  std::atomic<bool> result{true};
  parallel_slices(count, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!holds(i)) {
        result = false;
        return;
      }
    }
  });
  return result;
}

Result<void> check_vertex_count(std::size_t vertices, const std::string& where) {
  constexpr std::size_t kMostVertices = 0x7FFFFFFFU / 3;  // kernels address a coordinate by a signed 32-bit number
  if (vertices > kMostVertices) {
    return fail(ErrorKind::limit, where, fmt::format("has {} vertices; at most {} can be drawn", vertices, kMostVertices));
  }
  return {};
}

// A hand-built mesh is checked before anything reads through its indices.
Result<void> check_mesh(const Mesh& mesh, int threads, const std::string& where) {
  const std::size_t vertices = mesh.positions.size();
  if (auto checked = check_vertex_count(vertices, where); !checked) {
    return checked;
  }
  const auto fits = [vertices](std::size_t size) { return size == 0 || size == vertices; };
  if (!fits(mesh.normals.size()) || !fits(mesh.uvs.size()) || !fits(mesh.uvs1.size()) || !fits(mesh.tangents.size()) ||
      !fits(mesh.colors.size())) {
    return fail(ErrorKind::usage, where,
                fmt::format("normals, uvs, uvs1, tangents and colors must be empty or have one entry for each of the {} positions", vertices));
  }
  if (!all_of(vertices, threads, [&](std::size_t i) { return is_finite(mesh.positions[i]); })) {
    return fail(ErrorKind::usage, where, "has a position that is not finite");
  }
  const auto largest = [&](std::size_t i) { return std::max({mesh.triangles[i][0], mesh.triangles[i][1], mesh.triangles[i][2]}); };
  if (!all_of(mesh.triangles.size(), threads, [&](std::size_t i) { return largest(i) < vertices; })) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      if (largest(i) >= vertices) {
        return fail(ErrorKind::usage, where, fmt::format("a triangle names vertex {}, but there are {}", largest(i), vertices));
      }
    }
  }
  if (!mesh.triangle_material.empty() && mesh.triangle_material.size() != mesh.triangles.size()) {
    return fail(ErrorKind::usage, where, "triangle_material must be empty or have one entry for each triangle");
  }
  const std::size_t materials = std::max<std::size_t>(mesh.materials.size(), 1);
  for (const std::uint32_t m : mesh.triangle_material) {
    if (m >= materials) {
      return fail(ErrorKind::usage, where, fmt::format("a triangle names material {}, but there are {}", m, materials));
    }
  }
  return {};
}

bool is_unit(const Vec3f& n) {
  return std::abs(dot(n, n) - 1) < 1e-4F;
}

// The mesh with the normals that drawing needs: interpolation takes them for unit vectors.
std::shared_ptr<const Mesh> with_normals(const std::shared_ptr<const Mesh>& mesh, const MeshDemand& demand, int threads) {
  if (!demand.wants_normals && demand.displacement.empty()) {
    return mesh;
  }
  if (mesh->normals.empty()) {
    return std::make_shared<Mesh>(with_vertex_normals(*mesh, demand.normals));
  }
  if (all_of(mesh->normals.size(), threads, [&](std::size_t i) { return is_unit(mesh->normals[i]); })) {
    return mesh;
  }
  auto copy = std::make_shared<Mesh>(*mesh);
  for (Vec3f& n : copy->normals) {
    const Vec3d wide = vec_cast<double>(n);  // whatever its length, no digit is lost
    n = is_unit(n) || !(dot(wide, wide) > 0) ? n : vec_cast<float>(normalize(wide));
  }
  return copy;
}

}  // namespace

Result<std::shared_ptr<const DrawableMesh>> MeshCache::get(const std::shared_ptr<const Mesh>& mesh, const MeshDemand& demand, int threads,
                                                           const std::string& where) {
  for (Entry& entry : entries_) {
    if (entry.drawable->stated == mesh && entry.demand == demand) {
      entry.is_used = true;
      return entry.drawable;
    }
  }
  if (auto checked = check_mesh(*mesh, threads, where); !checked) {
    return tl::unexpected(checked.error());
  }
  auto drawable = std::make_shared<DrawableMesh>();
  drawable->stated = mesh;
  drawable->mesh = with_normals(mesh, demand, threads);
  if (!demand.displacement.empty()) {
    DisplacedMesh moved =
        displaced(*drawable->mesh, displacement_maps(demand.displacement), {.encoded_colors = demand.encoded_colors, .threads = threads});
    drawable->mesh = std::make_shared<const Mesh>(std::move(moved.mesh));
    drawable->note = std::move(moved.note);
  }
  if (demand.tangents && drawable->mesh->tangents.empty()) {
    drawable->mesh = std::make_shared<const Mesh>(with_tangents(*drawable->mesh, *demand.tangents));
  }
  if (auto checked = check_vertex_count(drawable->mesh->positions.size(), where); !checked) {  // there may be more now
    return tl::unexpected(checked.error());
  }
  drawable->colors.reserve(drawable->mesh->colors.size());
  for (const Vec3f& c : drawable->mesh->colors) {
    drawable->colors.push_back(demand.encoded_colors ? Vec3f{srgb_decode(c.x), srgb_decode(c.y), srgb_decode(c.z)} : c);
  }
  drawable->has_alphas = std::any_of(drawable->mesh->alphas.begin(), drawable->mesh->alphas.end(), [](float a) { return a < 1; });
  drawable->clusters = make_clusters(*drawable->mesh, use_, threads);
  if (demand.wants_cones && use_ == ClusterUse::often) {
    drawable->cones = make_cones(*drawable->mesh, drawable->clusters, threads);
  }
  entries_.push_back({drawable, demand});
  return std::shared_ptr<const DrawableMesh>(drawable);
}

void MeshCache::forget_unused() {
  std::erase_if(entries_, [](const Entry& entry) { return !entry.is_used; });
  for (Entry& entry : entries_) {
    entry.is_used = false;
  }
}

}  // namespace lustro
