// Meshes that need no file. Positions on a seam are shared by index and uvs are not, so every primitive but the plane and the teapot is closed,
// and no two of its positions are equal. Angles come from sine_deg(), exact at the quarters.
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "lustro/mesh.hpp"
#include "math/trig.hpp"
#include "mesh/weld.hpp"

namespace lustro {
namespace {

constexpr std::array<std::string_view, 5> kNames{"plane", "cube", "sphere", "torus", "teapot"};
constexpr std::uint32_t kLeastSegments = 3;
constexpr std::uint32_t kMostSegments = 1024;

/// Corner of a face: position, normal and uv by index.
struct Corner {
  std::uint32_t position, normal, uv;
};

void add_face(SourceMesh& mesh, std::initializer_list<Corner> corners) {
  for (const Corner& corner : corners) {
    mesh.corner_position.push_back(corner.position);
    mesh.corner_normal.push_back(corner.normal);
    mesh.corner_uv.push_back(corner.uv);
  }
  mesh.face_begin.push_back(static_cast<std::uint32_t>(mesh.corner_position.size()));
}

Vec3f rounded(double x, double y, double z) {
  return vec_cast<float>(Vec3d{x, y, z});
}

Vec2f uv_at(std::uint32_t column, std::uint32_t columns, std::uint32_t row, std::uint32_t rows) {
  return {static_cast<float>(static_cast<double>(column) / columns), static_cast<float>(static_cast<double>(row) / rows)};
}

/// -1, ..., 1 in equal steps.
double step(std::uint32_t i, std::uint32_t segments) {
  return 2.0 * i / segments - 1;
}

/// Appends n x n quads that span -1..1 along `u` and `v`, at `normal`; u x v = normal.
void add_square(SourceMesh& mesh, const Vec3d& normal, const Vec3d& u, const Vec3d& v, double height, std::uint32_t n) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const auto facing = static_cast<std::uint32_t>(mesh.normals.size());
  mesh.normals.push_back(vec_cast<float>(normal));
  for (std::uint32_t row = 0; row <= n; ++row) {
    for (std::uint32_t column = 0; column <= n; ++column) {
      mesh.positions.push_back(vec_cast<float>(normal * height + u * step(column, n) + v * step(row, n)));
      mesh.uvs.push_back(uv_at(column, n, row, n));
    }
  }
  const auto corner = [&](std::uint32_t column, std::uint32_t row) {
    const std::uint32_t i = first + row * (n + 1) + column;
    return Corner{i, facing, i};
  };
  for (std::uint32_t row = 0; row < n; ++row) {
    for (std::uint32_t column = 0; column < n; ++column) {
      add_face(mesh, {corner(column, row), corner(column + 1, row), corner(column + 1, row + 1), corner(column, row + 1)});
    }
  }
}

/// Gives equal positions one index and forgets the others.
void weld(SourceMesh& mesh) {
  const std::vector<std::uint32_t> first = weld_positions(mesh.positions);
  std::vector<std::uint32_t> index(first.size());
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < first.size(); ++i) {
    if (first[i] == i) {
      mesh.positions[kept] = mesh.positions[i];
      index[i] = kept++;
    }
  }
  mesh.positions.resize(kept);
  for (std::uint32_t& position : mesh.corner_position) {
    position = index[first[position]];
  }
}

SourceMesh make_plane(std::uint32_t n) {
  SourceMesh mesh;
  add_square(mesh, {0, 1, 0}, {1, 0, 0}, {0, 0, -1}, 0, n);
  return mesh;
}

SourceMesh make_cube(std::uint32_t n) {
  SourceMesh mesh;
  for (const double side : {1.0, -1.0}) {
    add_square(mesh, {side, 0, 0}, {0, 0, -side}, {0, 1, 0}, 1, n);
    add_square(mesh, {0, side, 0}, {1, 0, 0}, {0, 0, -side}, 1, n);
    add_square(mesh, {0, 0, side}, {side, 0, 0}, {0, 1, 0}, 1, n);
  }
  weld(mesh);
  return mesh;
}

/// Latitude and longitude: n segments around the y axis, n / 2 from pole to pole. u runs eastwards from the seam at -z, v from the south pole
/// up.
SourceMesh make_sphere(std::uint32_t n) {
  const std::uint32_t rings = std::max(2U, n / 2);
  SourceMesh mesh;
  mesh.positions.push_back({0, 1, 0});
  for (std::uint32_t ring = 1; ring < rings; ++ring) {
    const double polar = 180.0 * ring / rings;
    for (std::uint32_t i = 0; i < n; ++i) {
      const double longitude = 360.0 * i / n - 180;
      mesh.positions.push_back(rounded(sine_deg(polar) * sine_deg(longitude), cosine_deg(polar), sine_deg(polar) * cosine_deg(longitude)));
    }
  }
  mesh.positions.push_back({0, -1, 0});
  mesh.normals = mesh.positions;
  for (std::uint32_t ring = 0; ring <= rings; ++ring) {
    const bool pole = ring == 0 || ring == rings;
    for (std::uint32_t i = 0; i <= n; ++i) {  // at a pole, a triangle's uv stands in the middle of its side
      mesh.uvs.push_back(pole ? uv_at(2 * i + 1, 2 * n, rings - ring, rings) : uv_at(i, n, rings - ring, rings));
    }
  }
  const auto corner = [&](std::uint32_t ring, std::uint32_t i) {
    const std::uint32_t south = 1 + (rings - 1) * n;
    const std::uint32_t position = ring == 0 ? 0 : ring == rings ? south : 1 + (ring - 1) * n + i % n;
    return Corner{position, position, ring * (n + 1) + i};
  };
  for (std::uint32_t ring = 0; ring < rings; ++ring) {
    for (std::uint32_t i = 0; i < n; ++i) {
      if (ring == 0) {
        add_face(mesh, {corner(0, i), corner(1, i), corner(1, i + 1)});
      } else if (ring + 1 == rings) {
        add_face(mesh, {corner(ring, i), corner(rings, i), corner(ring, i + 1)});
      } else {
        add_face(mesh, {corner(ring, i), corner(ring + 1, i), corner(ring + 1, i + 1), corner(ring, i + 1)});
      }
    }
  }
  return mesh;
}

/// n segments around the y axis, n / 2 (at least 3) around the tube. u as the sphere's; v around the tube, from the outside up.
SourceMesh make_torus(std::uint32_t n) {
  constexpr double kRing = 0.7;
  constexpr double kTube = 0.3;
  const std::uint32_t around = std::max(3U, n / 2);
  SourceMesh mesh;
  for (std::uint32_t j = 0; j < around; ++j) {
    const double up = 360.0 * j / around;
    for (std::uint32_t i = 0; i < n; ++i) {
      const double longitude = 360.0 * i / n - 180;
      const double radius = kRing + kTube * cosine_deg(up);
      mesh.positions.push_back(rounded(radius * sine_deg(longitude), kTube * sine_deg(up), radius * cosine_deg(longitude)));
      mesh.normals.push_back(rounded(cosine_deg(up) * sine_deg(longitude), sine_deg(up), cosine_deg(up) * cosine_deg(longitude)));
    }
  }
  for (std::uint32_t j = 0; j <= around; ++j) {
    for (std::uint32_t i = 0; i <= n; ++i) {
      mesh.uvs.push_back(uv_at(i, n, j, around));
    }
  }
  const auto corner = [&](std::uint32_t j, std::uint32_t i) {
    const std::uint32_t position = j % around * n + i % n;
    return Corner{position, position, j * (n + 1) + i};
  };
  for (std::uint32_t j = 0; j < around; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      add_face(mesh, {corner(j + 1, i), corner(j, i), corner(j, i + 1), corner(j + 1, i + 1)});
    }
  }
  return mesh;
}

constexpr Vec3d kTeapotVertices[] = {
#define LUSTRO_VERTEX(x, y, z) Vec3d{x, y, z},
#define LUSTRO_FACE(a, b, c)
#include "mesh/teapot.inc"
#undef LUSTRO_VERTEX
#undef LUSTRO_FACE
};
constexpr std::uint16_t kTeapotCorners[] = {
#define LUSTRO_VERTEX(x, y, z)
#define LUSTRO_FACE(a, b, c) a, b, c,
#include "mesh/teapot.inc"
#undef LUSTRO_VERTEX
#undef LUSTRO_FACE
};

/// assets/utah_teapot, at the size that Newell gave it: the file is five times that, and its body stands beside the axis.
SourceMesh make_teapot() {
  constexpr Vec3d kFoot{-1.0703125, -7.875, 0};
  constexpr double kScale = 5;
  SourceMesh mesh;
  for (const Vec3d& p : kTeapotVertices) {
    mesh.positions.push_back(rounded((p.x - kFoot.x) / kScale, (p.y - kFoot.y) / kScale, (p.z - kFoot.z) / kScale));
  }
  mesh.corner_position.assign(std::begin(kTeapotCorners), std::end(kTeapotCorners));
  for (std::uint32_t end = 3; end <= mesh.corner_position.size(); end += 3) {
    mesh.face_begin.push_back(end);
  }
  weld(mesh);  // neighbouring patches repeat the positions of their common edge
  return mesh;
}

tl::unexpected<Error> usage(std::string message) {
  return fail(ErrorKind::usage, {}, std::move(message));
}

}  // namespace

std::span<const std::string_view> primitive_names() {
  return kNames;
}

Result<SourceMesh> make_primitive(std::string_view name) {
  const std::size_t colon = name.find(':');
  const std::string_view kind = name.substr(0, colon);
  if (std::find(kNames.begin(), kNames.end(), kind) == kNames.end()) {
    return usage(fmt::format("there is no primitive `{}`, expected one of {}", kind, fmt::join(kNames, ", ")));
  }
  std::optional<std::uint32_t> segments;
  if (colon != std::string_view::npos) {
    const std::string_view digits = name.substr(colon + 1);
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc{} || end != digits.data() + digits.size() || value < kLeastSegments || value > kMostSegments) {
      return usage(fmt::format("primitive `{}`: the number of segments is `{}`, expected {}..{}", name, digits, kLeastSegments, kMostSegments));
    }
    if (kind == "teapot") {
      return usage(fmt::format("primitive `{}`: a teapot has no segments", name));
    }
    segments = value;
  }
  SourceMesh mesh;
  if (kind == "plane") {
    mesh = make_plane(segments.value_or(1));
  } else if (kind == "cube") {
    mesh = make_cube(segments.value_or(1));
  } else if (kind == "sphere") {
    mesh = make_sphere(segments.value_or(64));
  } else if (kind == "torus") {
    mesh = make_torus(segments.value_or(64));
  } else {
    mesh = make_teapot();
  }
  mesh.format = "primitive";
  mesh.objects = {std::string(kind)};
  mesh.face_object.assign(mesh.face_count(), 0);
  return mesh;
}

}  // namespace lustro
