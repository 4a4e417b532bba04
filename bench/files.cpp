// bench_files FOLDER NAME...: writes meshes for the comparisons of whole processes. NAME is SUBJECT.ply (binary, little endian, positions only),
// SUBJECT.obj (positions and normals) or SUBJECT-COUNT.ply: so many different meshes as SUBJECT-0.ply, SUBJECT-1.ply, ...
#include <fmt/format.h>

#include <bit>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "common/subjects.hpp"

namespace lustro::bench {
namespace {

static_assert(std::endian::native == std::endian::little, "the PLY files are written as the numbers lie in memory");

void save(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream out(file, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) {
    throw std::runtime_error(file.string() + " cannot be written");
  }
}

template <class T>
void append(std::string& bytes, const T& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

std::string ply_of(const Mesh& mesh) {
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\nelement face {}\nproperty "
      "list uchar int vertex_indices\nend_header\n",
      mesh.positions.size(), mesh.triangles.size());
  bytes.reserve(bytes.size() + 12 * mesh.positions.size() + 13 * mesh.triangles.size());
  for (const Vec3f& p : mesh.positions) {
    append(bytes, p);
  }
  for (const auto& corners : mesh.triangles) {
    bytes.push_back(3);
    append(bytes, corners);
  }
  return bytes;
}

std::string obj_of(const Mesh& mesh) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  for (const Vec3f& p : mesh.positions) {
    fmt::format_to(out, "v {:.6f} {:.6f} {:.6f}\n", p.x, p.y, p.z);
  }
  for (const Vec3f& n : mesh.normals) {
    fmt::format_to(out, "vn {:.6f} {:.6f} {:.6f}\n", n.x, n.y, n.z);
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    fmt::format_to(out, "f {0}//{0} {1}//{1} {2}//{2}\n", a + 1, b + 1, c + 1);
  }
  return fmt::to_string(text);
}

void write_named(const std::filesystem::path& folder, const std::string& name) {
  const std::size_t dot = name.rfind('.');
  const std::size_t dash = name.find('-');
  const Subject* subject = dot == std::string::npos ? nullptr : find_subject(name.substr(0, std::min(dash, dot)));
  const std::string ending = subject != nullptr ? name.substr(dot) : std::string();
  if (subject == nullptr || subject->fills_the_picture || (ending != ".ply" && ending != ".obj")) {
    throw std::runtime_error(name + " is no mesh that is known here");
  }
  if (dash != std::string::npos) {
    const int count = std::stoi(name.substr(dash + 1));
    for (int i = 0; i < count; ++i) {
      save(folder / fmt::format("{}-{}.ply", subject->name, i), ply_of(bumpy_torus(subject->triangles, i)));
    }
    return;
  }
  const Mesh mesh = bumpy_torus(subject->triangles);
  save(folder / name, ending == ".ply" ? ply_of(mesh) : obj_of(mesh));
}

}  // namespace
}  // namespace lustro::bench

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: bench_files FOLDER NAME...\n");
    return 2;
  }
  try {
    for (int i = 2; i < argc; ++i) {
      lustro::bench::write_named(argv[1], argv[i]);
    }
  } catch (const std::exception& e) {
    std::fprintf(stderr, "bench_files: %s\n", e.what());
    return 1;
  }
  return 0;
}
