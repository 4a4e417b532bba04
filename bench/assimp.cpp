// bench_assimp FILE.obj [SECONDS]: load_mesh_file() beside assimp without any post-processing, from the file to a mesh in memory. Compared
// first: the number of faces and the box of the positions (assimp keeps a vertex of its own for every corner).
#include <assimp/scene.h>
#include <fmt/format.h>

#include <assimp/Importer.hpp>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "common/measure.hpp"
#include "lustro/scene.hpp"

namespace lustro::bench {
namespace {

SourceMesh by_ours(const std::string& file) {
  Result<SourceMesh> mesh = load_mesh_file(file);
  if (!mesh) {
    throw std::runtime_error(mesh.error().text());
  }
  return std::move(*mesh);
}

const aiScene& by_assimp(Assimp::Importer& importer, const std::string& file) {
  const aiScene* scene = importer.ReadFile(file, 0);
  if (scene == nullptr) {
    throw std::runtime_error(std::string("assimp: ") + importer.GetErrorString());
  }
  return *scene;
}

std::string difference(const SourceMesh& ours, const aiScene& peer) {
  std::size_t faces = 0;
  Bounds theirs;
  for (unsigned m = 0; m < peer.mNumMeshes; ++m) {
    const aiMesh& mesh = *peer.mMeshes[m];
    faces += mesh.mNumFaces;
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D& p = mesh.mVertices[v];
      theirs.include({static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)});
    }
  }
  if (faces != ours.face_count()) {
    return fmt::format("{} faces here, {} there", ours.face_count(), faces);
  }
  Bounds box;
  for (const Vec3f& p : ours.positions) {
    box.include(vec_cast<double>(p));
  }
  const Vec3d a = box.lower - theirs.lower;
  const Vec3d b = box.upper - theirs.upper;
  return dot(a, a) + dot(b, b) < 1e-10 ? std::string() : "the boxes differ";
}

int compare(const std::string& file, double seconds) {
  std::string check;
  {
    const SourceMesh ours = by_ours(file);
    Assimp::Importer importer;
    if (const std::string d = difference(ours, by_assimp(importer, file)); !d.empty()) {
      report_failure("obj/assimp", d);
      return 1;
    }
    check = fmt::format("equal: {} faces and their box", ours.face_count());
  }
  const std::vector<Side> sides{{"ours", [&](int) { (void)by_ours(file); }}, {"peer", [&](int) {
                                                                                Assimp::Importer importer;
                                                                                (void)by_assimp(importer, file);
                                                                              }}};
  report("obj/assimp", check, sides, in_turns(sides, {.turn_ms = 300, .most_seconds = seconds}));
  return 0;
}

}  // namespace
}  // namespace lustro::bench

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: bench_assimp FILE.obj [SECONDS]\n");
    return 2;
  }
  try {
    return lustro::bench::compare(argv[1], argc > 2 ? std::atof(argv[2]) : 30);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "bench_assimp: %s\n", e.what());
    return 1;
  }
}
