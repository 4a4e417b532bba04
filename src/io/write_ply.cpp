// PLY (Turk 1994): vertices with all that they have, then triangles. Properties have the names that most programs read: x y z, nx ny nz, s t,
// red green blue alpha.
#include <fmt/format.h>

#include "image/srgb.hpp"
#include "io/mesh_writers.hpp"
#include "io/write_bytes.hpp"
#include "io/write_text.hpp"

namespace lustro {
namespace {

constexpr std::size_t kMostSignedIndices = 0x80000000U;

bool is_byte(float x) {
  return static_cast<float>(quantize8(x)) / 255.0F == x;
}

bool are_bytes(const Mesh& mesh) {
  bool all = true;
  for (const Vec3f& c : mesh.colors) {
    all = all && is_byte(c.x) && is_byte(c.y) && is_byte(c.z);
  }
  for (const float alpha : mesh.alphas) {
    all = all && is_byte(alpha);
  }
  return all;
}

std::string header(const Mesh& mesh, bool ascii, bool has_color) {
  std::string text =
      fmt::format("ply\nformat {} 1.0\ncomment written by Lustro\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n",
                  ascii ? "ascii" : "binary_little_endian", mesh.positions.size());
  text += mesh.normals.empty() ? "" : "property float nx\nproperty float ny\nproperty float nz\n";
  text += mesh.uvs.empty() ? "" : "property float s\nproperty float t\n";
  text += has_color ? "property uchar red\nproperty uchar green\nproperty uchar blue\n" : "";
  text += mesh.alphas.empty() ? "" : "property uchar alpha\n";
  return text + fmt::format("element face {}\nproperty list uchar {} vertex_indices\nend_header\n", mesh.triangles.size(),
                            mesh.positions.size() > kMostSignedIndices ? "uint" : "int");  // many programs read `int` alone
}

struct AsText {
  std::string& out;
  void number(float x) { append_number(out, x); }
  void byte(std::uint8_t x) { append_number(out, std::uint32_t{x}); }
  void index(std::uint32_t x) { append_number(out, x); }
  void end_line(std::size_t& begin) {
    out.erase(begin, 1);  // the blank before the first number
    out += '\n';
    begin = out.size();
  }
};
struct AsBytes {
  std::string& out;
  void number(float x) { append_f32(out, x); }
  void byte(std::uint8_t x) { out += static_cast<char>(x); }
  void index(std::uint32_t x) { append_u32(out, x); }
  void end_line(std::size_t& /*begin*/) {}
};

template <class To>
void append_body(const Mesh& mesh, bool has_color, To to) {
  std::size_t line = to.out.size();
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const auto vector = [&to](const Vec3f& a) {
      to.number(a.x);
      to.number(a.y);
      to.number(a.z);
    };
    vector(mesh.positions[v]);
    if (!mesh.normals.empty()) {
      vector(mesh.normals[v]);
    }
    if (!mesh.uvs.empty()) {
      to.number(mesh.uvs[v].x);
      to.number(mesh.uvs[v].y);
    }
    if (has_color) {
      const Vec3f color = mesh.colors.empty() ? Vec3f{1, 1, 1} : mesh.colors[v];
      to.byte(quantize8(color.x));
      to.byte(quantize8(color.y));
      to.byte(quantize8(color.z));
    }
    if (!mesh.alphas.empty()) {
      to.byte(quantize8(mesh.alphas[v]));
    }
    to.end_line(line);
  }
  for (const auto& triangle : mesh.triangles) {
    to.byte(3);
    for (const std::uint32_t corner : triangle) {
      to.index(corner);
    }
    to.end_line(line);
  }
}

}  // namespace

MeshBytes ply_bytes(const Mesh& mesh, bool ascii) {
  const bool has_color = !mesh.colors.empty() || !mesh.alphas.empty();
  MeshBytes ply{header(mesh, ascii, has_color), {}};
  if (ascii) {
    append_body(mesh, has_color, AsText{ply.bytes});
  } else {
    ply.bytes.reserve(ply.bytes.size() + mesh.positions.size() * 36 + mesh.triangles.size() * 13);
    append_body(mesh, has_color, AsBytes{ply.bytes});
  }
  if (!are_bytes(mesh)) {
    ply.notes.push_back({"", "colours are rounded to 8 bits"});
  }
  if (has_materials(mesh)) {
    ply.notes.push_back({"", fmt::format("PLY holds no materials: {} left out",
                                         mesh.materials.size() == 1 ? "one is" : fmt::format("{} are", mesh.materials.size()))});
  }
  if (!mesh.uvs1.empty()) {
    ply.notes.push_back({"", "PLY holds one set of texture coordinates: the second is left out"});
  }
  return ply;
}

}  // namespace lustro
