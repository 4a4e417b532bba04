// Checks first, without touching anything; then one pass that repairs the values, and one that keeps the faces worth keeping.
#include "mesh/validate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <utility>

#include "mesh/repair.hpp"
#include "mesh/weld.hpp"
#include "parallel/slices.hpp"

namespace lustro {
namespace {

constexpr std::uint32_t kNone = SourceMesh::kNone;

tl::unexpected<Error> malformed(std::string message) {
  return fail(ErrorKind::malformed, {}, std::move(message));
}

/// A stream with one entry per `of` is there or empty.
Result<void> check_length(std::size_t found, std::size_t expected, const char* stream, const char* of) {
  if (found != 0 && found != expected) {
    return malformed(fmt::format("{} has {} entries, expected one for each of the {} {}", stream, found, expected, of));
  }
  return {};
}

/// Every entry lies inside an array of `size`, or is kNone where that is allowed.
Result<void> check_indices(const std::vector<std::uint32_t>& indices, std::size_t size, bool may_be_none, const char* stream, const char* of,
                           int threads) {
  std::atomic<bool> is_good = true;
  const std::uint32_t offset = may_be_none ? 1 : 0;  // kNone becomes 0, which is below everything
  parallel_slices(indices.size(), threads, [&](std::size_t begin, std::size_t end) {
    std::uint32_t largest = 0;
    for (std::size_t i = begin; i < end; ++i) {
      largest = std::max(largest, indices[i] + offset);
    }
    if (largest >= size + offset) {
      is_good = false;
    }
  });
  for (std::size_t i = 0; !is_good && i < indices.size(); ++i) {
    if (indices[i] >= size && !(may_be_none && indices[i] == kNone)) {
      return malformed(fmt::format("{}[{}] is {}, expected an index below {}, the number of {}", stream, i, indices[i], size, of));
    }
  }
  return {};
}

Result<void> check_faces(const SourceMesh& source) {
  const auto& begin = source.face_begin;
  if (begin.empty() || begin.front() != 0) {
    return malformed("face_begin does not begin with 0");
  }
  for (std::size_t f = 0; f + 1 < begin.size(); ++f) {
    if (begin[f] > begin[f + 1]) {
      return malformed(fmt::format("face_begin[{}] is {}, smaller than the {} before it", f + 1, begin[f + 1], begin[f]));
    }
  }
  if (begin.back() != source.corner_position.size()) {
    return malformed(fmt::format("face_begin ends with {}, but there are {} corners", begin.back(), source.corner_position.size()));
  }
  return {};
}

/// Corners forget the normals that could not be made unit vectors.
void forget_unusable_normals(SourceMesh& mesh) {
  for (std::uint32_t& normal : mesh.corner_normal) {
    if (normal != kNone && mesh.normals[normal] == Vec3f{}) {
      normal = kNone;
    }
  }
}

void weld(ValidMesh& mesh, int threads) {
  SourceMesh& source = mesh.source;
  if (!source.colors.empty()) {
    mesh.corner_color = source.corner_position;
  }
  const std::vector<std::uint32_t> first = weld_positions(source.positions, 0, threads);
  parallel_slices(source.corner_position.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      source.corner_position[c] = first[source.corner_position[c]];
    }
  });
}

struct Dropped {
  std::size_t infinite_faces = 0;
  std::size_t thin_faces = 0;
  std::size_t repeated_corners = 0;
};

/// True where drop_faces() would leave everything as it is.
bool is_clean(const SourceMesh& s, int threads) {
  std::atomic<bool> is_good = true;
  const auto place = [&](std::uint32_t c) -> const Vec3f& { return s.positions[s.corner_position[c]]; };
  parallel_slices(s.face_count(), threads, [&](std::size_t first, std::size_t last) {
    bool good = true;
    for (std::size_t f = first; f < last && good; ++f) {
      const std::uint32_t begin = s.face_begin[f];
      const std::uint32_t end = s.face_begin[f + 1];
      bool is_wide = false;  // a third place
      good = end - begin >= 3;
      for (std::uint32_t c = begin; c < end && good; ++c) {
        good = is_finite(place(c)) && place(c) != place(c + 1 < end ? c + 1 : begin);
        is_wide = is_wide || (place(c) != place(begin) && place(c) != place(begin + 1));
      }
      good = good && is_wide;
    }
    if (!good) {
      is_good = false;
    }
  });
  return is_good;
}

/// Keeps the faces and corners that can be drawn, in their order and in place: what is written never overtakes what is read.
Dropped drop_faces(ValidMesh& mesh) {
  SourceMesh& s = mesh.source;
  Dropped dropped;
  std::uint32_t corners = 0;
  std::size_t faces = 0;
  const auto keep_corner = [&](std::uint32_t to, std::uint32_t from) {
    s.corner_position[to] = s.corner_position[from];
    if (!s.corner_normal.empty()) {
      s.corner_normal[to] = s.corner_normal[from];
    }
    if (!s.corner_uv.empty()) {
      s.corner_uv[to] = s.corner_uv[from];
    }
    if (!mesh.corner_color.empty()) {
      mesh.corner_color[to] = mesh.corner_color[from];
    }
  };
  const auto same_place = [&](std::uint32_t a, std::uint32_t b) {
    return s.corner_position[a] == s.corner_position[b] || s.positions[s.corner_position[a]] == s.positions[s.corner_position[b]];
  };
  std::uint32_t begin = 0;
  for (std::size_t f = 0; f < s.face_count(); ++f) {
    const std::uint32_t end = s.face_begin[f + 1];
    const std::uint32_t kept_begin = corners;
    bool finite = true;
    for (std::uint32_t c = begin; c < end; ++c) {
      finite = finite && is_finite(s.positions[s.corner_position[c]]);
      keep_corner(corners, c);
      if (corners == kept_begin || !same_place(corners - 1, corners)) {
        ++corners;
      }
    }
    while (corners > kept_begin + 1 && same_place(corners - 1, kept_begin)) {
      --corners;
    }
    bool thin = true;  // a walk to and fro between two places has any number of corners
    for (std::uint32_t c = kept_begin + 2; c < corners && thin; ++c) {
      thin = same_place(c, kept_begin) || same_place(c, kept_begin + 1);
    }
    if (!finite || thin) {
      ++(finite ? dropped.thin_faces : dropped.infinite_faces);
      corners = kept_begin;
    } else {
      dropped.repeated_corners += (end - begin) - (corners - kept_begin);
      if (!s.face_smoothing.empty()) {
        s.face_smoothing[faces] = s.face_smoothing[f];
      }
      if (!s.face_material.empty()) {
        s.face_material[faces] = s.face_material[f];
      }
      if (!s.face_colors.empty()) {
        s.face_colors[faces] = s.face_colors[f];
      }
      s.face_begin[++faces] = corners;
    }
    begin = end;
  }
  const auto shrink = [](auto& stream, std::size_t size) { stream.resize(std::min(stream.size(), size)); };
  shrink(s.face_begin, faces + 1);
  shrink(s.face_smoothing, faces);
  shrink(s.face_material, faces);
  shrink(s.face_colors, faces);
  shrink(s.corner_position, corners);
  shrink(s.corner_normal, corners);
  shrink(s.corner_uv, corners);
  shrink(mesh.corner_color, corners);
  return dropped;
}

}  // namespace

std::string counted(std::size_t count, const char* singular, const char* plural) {
  return fmt::format("{} {}", count, count == 1 ? singular : plural);
}

Result<void> check_count(std::size_t count, const char* what) {
  if (count > kNone - 1) {
    return fail(ErrorKind::limit, {}, fmt::format("{} {} are more than the {} that can be indexed", count, what, kNone - 1));
  }
  return {};
}

Result<void> check_source(const SourceMesh& s, int threads) {
  const std::size_t corners = s.corner_position.size();
  return check_count(s.positions.size(), "positions")
      .and_then([&] { return check_count(s.normals.size(), "normals"); })
      .and_then([&] { return check_count(s.uvs.size(), "texture coordinates"); })
      .and_then([&] { return check_count(corners, "corners"); })
      .and_then([&] { return check_count(s.face_begin.size(), "faces"); })
      .and_then([&] { return check_faces(s); })
      .and_then([&] { return check_length(s.colors.size(), s.positions.size(), "colors", "positions"); })
      .and_then([&] { return check_length(s.face_colors.size(), s.face_count(), "face_colors", "faces"); })
      .and_then([&] { return check_length(s.uvs1.size(), s.positions.size(), "uvs1", "positions"); })
      .and_then([&] { return check_length(s.tangents.size(), s.positions.size(), "tangents", "positions"); })
      .and_then([&] { return check_length(s.alphas.size(), s.positions.size(), "alphas", "positions"); })
      .and_then([&] { return check_length(s.corner_normal.size(), corners, "corner_normal", "corners"); })
      .and_then([&] { return check_length(s.corner_uv.size(), corners, "corner_uv", "corners"); })
      .and_then([&] { return check_length(s.face_smoothing.size(), s.face_count(), "face_smoothing", "faces"); })
      .and_then([&] { return check_length(s.face_material.size(), s.face_count(), "face_material", "faces"); })
      .and_then([&] { return check_length(s.face_object.size(), s.face_count(), "face_object", "faces"); })
      .and_then([&] { return check_indices(s.corner_position, s.positions.size(), false, "corner_position", "positions", threads); })
      .and_then([&] { return check_indices(s.corner_normal, s.normals.size(), true, "corner_normal", "normals", threads); })
      .and_then([&] { return check_indices(s.corner_uv, s.uvs.size(), true, "corner_uv", "texture coordinates", threads); })
      .and_then([&] { return check_indices(s.face_material, s.materials.size(), true, "face_material", "materials", threads); })
      .and_then([&] { return check_indices(s.face_object, s.objects.size(), true, "face_object", "objects", threads); });
}

Result<ValidMesh> validate(const SourceMesh& source) {
  return validate(SourceMesh(source), 0);
}

Result<ValidMesh> validate(SourceMesh&& source, int threads) {
  if (Result<void> checked = check_source(source, threads); !checked) {
    return tl::unexpected<Error>(checked.error());
  }
  ValidMesh mesh{std::move(source), {}, {}};
  mesh.source.materials = {};
  mesh.source.objects = {};
  mesh.source.face_object = {};
  mesh.source.notes = {};
  const auto note = [&](std::size_t count, const char* singular, const char* plural, const char* what) {
    if (count > 0) {
      mesh.notes.push_back({{}, fmt::format("{} {}", counted(count, singular, plural), what)});
    }
  };
  const std::size_t white = whiten(mesh.source.colors, threads) + whiten(mesh.source.face_colors, threads);
  note(white, "colour", "colours", "not finite: white instead");
  note(replace_uvs(mesh.source.uvs, threads) + replace_uvs(mesh.source.uvs1, threads), "texture coordinate", "texture coordinates",
       "not finite: (0, 0) instead");
  const std::size_t unusable = normalize_normals(mesh.source.normals, threads);
  note(unusable, "normal", "normals", "zero or not finite: made from the faces instead");
  if (unusable > 0) {
    forget_unusable_normals(mesh.source);
  }
  if (mesh.source.weld_first) {
    weld(mesh, threads);
  }
  const Dropped dropped = is_clean(mesh.source, threads) ? Dropped{} : drop_faces(mesh);
  note(dropped.infinite_faces, "face", "faces", "with a position that is not finite: dropped");
  note(dropped.thin_faces, "face", "faces", "with fewer than three distinct corners: dropped");
  note(dropped.repeated_corners, "corner", "corners", "at the place of the corner before: dropped");
  return mesh;
}

}  // namespace lustro
