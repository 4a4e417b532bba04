// bench_tinyobjloader FILE.obj [SECONDS]: load_mesh_file() beside tinyobjloader, from the file to positions, normals and corners in memory.
// Compared first: every position and every corner.
#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "common/measure.hpp"
#include "lustro/scene.hpp"

namespace lustro::bench {
namespace {

struct Peer {
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
};

Peer by_tinyobjloader(const std::string& file) {
  Peer peer;
  std::string warning;
  std::string error;
  if (!tinyobj::LoadObj(&peer.attributes, &peer.shapes, &peer.materials, &warning, &error, file.c_str())) {
    throw std::runtime_error("tinyobjloader: " + error);
  }
  return peer;
}

SourceMesh by_ours(const std::string& file) {
  Result<SourceMesh> mesh = load_mesh_file(file);
  if (!mesh) {
    throw std::runtime_error(mesh.error().text());
  }
  return std::move(*mesh);
}

/// tinyobjloader's numbers may lie a unit in the last place from the nearest float, for it sums up digits.
bool is_close(float a, float b) {
  return std::abs(a - b) <= 1e-6F * (1 + std::abs(a));
}

std::string difference(const SourceMesh& ours, const Peer& peer) {
  if (ours.positions.size() * 3 != peer.attributes.vertices.size() || ours.normals.size() * 3 != peer.attributes.normals.size()) {
    return "the numbers of positions or normals differ";
  }
  for (std::size_t i = 0; i < ours.positions.size(); ++i) {
    const float* p = &peer.attributes.vertices[3 * i];
    if (!is_close(ours.positions[i].x, p[0]) || !is_close(ours.positions[i].y, p[1]) || !is_close(ours.positions[i].z, p[2])) {
      return fmt::format("position {} differs", i);
    }
  }
  std::size_t corner = 0;
  for (const tinyobj::shape_t& shape : peer.shapes) {
    for (const tinyobj::index_t& index : shape.mesh.indices) {
      if (corner >= ours.corner_position.size() || ours.corner_position[corner] != static_cast<std::uint32_t>(index.vertex_index) ||
          ours.corner_normal[corner] != static_cast<std::uint32_t>(index.normal_index)) {
        return fmt::format("corner {} differs", corner);
      }
      ++corner;
    }
  }
  return corner == ours.corner_position.size() ? std::string() : "the numbers of corners differ";
}

int compare(const std::string& file, double seconds) {
  std::string check;
  {
    const SourceMesh ours = by_ours(file);
    if (const std::string d = difference(ours, by_tinyobjloader(file)); !d.empty()) {
      report_failure("obj/tinyobjloader", d);
      return 1;
    }
    check = fmt::format("equal: {} positions, {} corners", ours.positions.size(), ours.corner_position.size());
  }
  const std::vector<Side> sides{{"ours", [&](int) { (void)by_ours(file); }}, {"peer", [&](int) { (void)by_tinyobjloader(file); }}};
  report("obj/tinyobjloader", check, sides, in_turns(sides, {.turn_ms = 300, .most_seconds = seconds}));
  return 0;
}

}  // namespace
}  // namespace lustro::bench

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: bench_tinyobjloader FILE.obj [SECONDS]\n");
    return 2;
  }
  try {
    return lustro::bench::compare(argv[1], argc > 2 ? std::atof(argv[2]) : 30);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "bench_tinyobjloader: %s\n", e.what());
    return 1;
  }
}
