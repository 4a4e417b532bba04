// From the package to a mesh: parts are read when they are named, everything is counted before it is placed.
#include "io/threemf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "image/srgb.hpp"
#include "io/limits.hpp"
#include "io/note_book.hpp"
#include "io/text.hpp"
#include "io/threemf_model.hpp"
#include "io/zip.hpp"

namespace lustro {
namespace {

constexpr std::uint32_t kNone = SourceMesh::kNone;
constexpr std::size_t kMostDepth = 64;
constexpr std::string_view kRelationships = "_rels/.rels";
constexpr std::string_view kUsualModel = "3D/3dmodel.model";

using Kind = ThreeMfGroup::Kind;

/// A model part and what was found out about its objects.
struct Part {
  std::string name;
  ThreeMfModel model;
  NoteBook notes;
  std::map<std::uint32_t, std::uint32_t> first_material;  ///< of base groups, once one of their materials is used
};

/// An object with all its components.
struct Size {
  std::uint64_t uses = 0;
  std::uint64_t triangles = 0;
  std::uint64_t vertices = 0;
  std::size_t height = 1;  ///< of components in components
  bool is_open = false;    ///< being counted: to meet it again is a cycle
};

class Package {
 public:
  Package(ZipArchive archive, const ThreeMfLimits& limits) : archive_(std::move(archive)), limits_(limits), notes_(archive_.file) {}

  Result<SourceMesh> read();

 private:
  Result<std::string> find_model();
  Result<std::string> read_part(std::string_view name);
  Result<Part*> open_part(const std::string& name);
  Result<Part*> part_of(const ThreeMfUse& use, Part& part) { return use.part.empty() ? Result<Part*>(&part) : open_part(use.part); }
  Result<const ThreeMfObject*> object_of(const ThreeMfUse& use, const Part& from, const Part& part) const;
  Result<Size> count(const ThreeMfUse& use, Part& from, std::size_t depth);
  Result<void> place(const ThreeMfUse& use, Part& from, const Mat4& outer);
  Result<void> place_mesh(const ThreeMfObject& object, std::uint32_t id, Part& part, const Mat4& matrix);
  Result<void> add_surface(Part& part, const ThreeMfTriangle& triangle, std::uint32_t id, std::array<std::uint32_t, 3>& colors);
  void add_material(Part& part, std::uint32_t group, std::uint32_t property);
  void finish();

  [[nodiscard]] std::string place_of(const Part& part, std::size_t line) const { return at_line(where(part.name), line); }
  [[nodiscard]] std::string where(const std::string& part) const { return fmt::format("{}: {}", archive_.file, to_utf8(part)); }

  ZipArchive archive_;
  ThreeMfLimits limits_;
  NoteBook notes_;
  std::map<std::string, Part> parts_;
  std::map<std::pair<const Part*, std::uint32_t>, Size> sizes_;
  SourceMesh mesh_;
  bool has_materials_ = false, has_face_colors_ = false, has_corner_colors_ = false;
};

Result<std::string> Package::read_part(std::string_view name) {
  Result<std::string> bytes = read_zip_part(archive_, name, limits_.bytes);
  if (bytes) {
    limits_.bytes -= bytes->size();
  }
  return bytes;
}

Result<std::string> Package::find_model() {
  if (archive_.parts.contains(kRelationships)) {
    const Result<std::string> xml = read_part(kRelationships);
    if (!xml) {
      return tl::unexpected(xml.error());
    }
    Result<std::string> target = parse_threemf_relationships(*xml, where(std::string(kRelationships)));
    if (!target || !target->empty()) {
      return target;
    }
  }
  if (archive_.parts.contains(kUsualModel)) {
    return std::string(kUsualModel);
  }
  return fail(ErrorKind::unsupported, archive_.file, "is a ZIP archive without a 3MF model");
}

Result<Part*> Package::open_part(const std::string& name) {
  if (const auto known = parts_.find(name); known != parts_.end()) {
    return &known->second;
  }
  const Result<std::string> xml = read_part(name);
  if (!xml) {
    return tl::unexpected(xml.error());
  }
  NoteBook notes(where(name));
  Result<ThreeMfModel> model = parse_threemf_model(*xml, where(name), notes);
  if (!model) {
    return tl::unexpected(model.error());
  }
  return &parts_.emplace(name, Part{name, *std::move(model), std::move(notes), {}}).first->second;
}

Result<const ThreeMfObject*> Package::object_of(const ThreeMfUse& use, const Part& from, const Part& part) const {
  const auto found = part.model.objects.find(use.object);
  if (found == part.model.objects.end()) {
    return fail(ErrorKind::malformed, place_of(from, use.line),
                fmt::format("object {} is not in {}", use.object, use.part.empty() ? "the model" : shown(part.name)));
  }
  return &found->second;
}

Result<Size> Package::count(const ThreeMfUse& use, Part& from, std::size_t depth) {
  const Result<Part*> part = part_of(use, from);
  if (!part) {
    return tl::unexpected(part.error());
  }
  const Result<const ThreeMfObject*> object = object_of(use, from, **part);
  if (!object) {
    return tl::unexpected(object.error());
  }
  const auto key = std::pair<const Part*, std::uint32_t>(*part, use.object);
  if (const auto known = sizes_.find(key); known != sizes_.end()) {
    if (known->second.is_open) {
      return fail(ErrorKind::malformed, place_of(from, use.line), fmt::format("object {} holds itself", use.object));
    }
    return known->second;
  }
  const auto too_deep = [&] {
    return fail(ErrorKind::limit, place_of(from, use.line), fmt::format("components are nested deeper than {}", kMostDepth));
  };
  if (depth == kMostDepth) {
    return too_deep();
  }
  sizes_[key].is_open = true;
  Size size{(*object)->triangles.empty() ? 0U : 1U, (*object)->triangles.size(), (*object)->positions.size()};
  for (const ThreeMfUse& component : (*object)->components) {
    const Result<Size> inner = count(component, **part, depth + 1);
    if (!inner) {
      return inner;
    }
    // Objects without triangles count, too: placing them takes time.
    size.uses += std::max<std::uint64_t>(inner->uses, 1);
    size.triangles += inner->triangles;
    size.vertices += inner->vertices;
    size.height = std::max(size.height, inner->height + 1);
    if (size.height > kMostDepth) {
      return too_deep();
    }
    if (size.uses > limits_.uses || size.triangles > limits_.triangles || size.vertices > 3 * limits_.triangles) {
      return fail(ErrorKind::limit, place_of(from, use.line),
                  fmt::format("object {} places {} meshes, {} triangles and {} vertices or more, and at most {}, {} and {} are read", use.object,
                              size.uses, size.triangles, size.vertices, limits_.uses, limits_.triangles, 3 * limits_.triangles));
    }
  }
  return sizes_[key] = size;
}

Result<void> Package::place(const ThreeMfUse& use, Part& from, const Mat4& outer) {
  Part& part = **part_of(use, from);  // count() has found all of them
  const ThreeMfObject& object = **object_of(use, from, part);
  const Mat4 matrix = outer * use.matrix;
  if (!object.triangles.empty()) {
    if (const Result<void> placed = place_mesh(object, use.object, part, matrix); !placed) {
      return placed;
    }
  }
  for (const ThreeMfUse& component : object.components) {
    if (const Result<void> placed = place(component, part, matrix); !placed) {
      return placed;
    }
  }
  return {};
}

double determinant(const Mat4& m) {
  return dot(Vec3d{m(0, 0), m(0, 1), m(0, 2)}, cross(Vec3d{m(1, 0), m(1, 1), m(1, 2)}, Vec3d{m(2, 0), m(2, 1), m(2, 2)}));
}

std::uint32_t packed(const Vec3f& color) {
  return std::uint32_t{quantize8(color.x)} | std::uint32_t{quantize8(color.y)} << 8U | std::uint32_t{quantize8(color.z)} << 16U;
}
Vec3f unpacked(std::uint32_t color) {
  const auto channel = [color](unsigned shift) { return static_cast<float>((color >> shift) & 0xFFU) / 255.0F; };
  return {channel(0), channel(8), channel(16)};
}
constexpr std::uint32_t kWhite = 0xFFFFFF;

Result<void> Package::place_mesh(const ThreeMfObject& object, std::uint32_t id, Part& part, const Mat4& matrix) {
  const bool is_mirrored = determinant(matrix) < 0;
  const auto object_index = static_cast<std::uint32_t>(mesh_.objects.size());
  mesh_.objects.push_back(to_utf8(object.name));
  // A vertex is there once for each colour that its corners have.
  std::vector<std::uint32_t> white(object.positions.size(), kNone);
  std::unordered_map<std::uint64_t, std::uint32_t> colored;
  for (const ThreeMfTriangle& stated : object.triangles) {
    ThreeMfTriangle triangle = stated;
    if (is_mirrored) {
      std::swap(triangle.corner[1], triangle.corner[2]);
      std::swap(triangle.property[1], triangle.property[2]);
    }
    std::array<std::uint32_t, 3> colors{kWhite, kWhite, kWhite};
    if (const Result<void> added = add_surface(part, triangle, id, colors); !added) {
      return added;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = triangle.corner[i];
      const auto fresh = static_cast<std::uint32_t>(mesh_.positions.size());
      std::uint32_t& index = colors[i] == kWhite ? white[v] : colored.try_emplace(std::uint64_t{v} << 32U | colors[i], kNone).first->second;
      if (index == kNone) {
        index = fresh;
        const Vec3f& p = object.positions[v];
        mesh_.positions.push_back(matrix == Mat4{} ? p : vec_cast<float>(transform_point(matrix, vec_cast<double>(p))));
        mesh_.colors.push_back(unpacked(colors[i]));
      }
      mesh_.corner_position.push_back(index);
    }
    mesh_.face_begin.push_back(static_cast<std::uint32_t>(mesh_.corner_position.size()));
    mesh_.face_object.push_back(object_index);
  }
  return {};
}

/// Material, face colour and corners' colours of the triangle that comes next.
Result<void> Package::add_surface(Part& part, const ThreeMfTriangle& triangle, std::uint32_t id, std::array<std::uint32_t, 3>& colors) {
  mesh_.face_material.push_back(kNone);
  mesh_.face_colors.push_back({1, 1, 1});
  if (triangle.group == 0) {
    return {};
  }
  const auto found = part.model.groups.find(triangle.group);
  if (found == part.model.groups.end()) {
    part.notes.add(0, "triangles name groups of properties that are not there, and have none");
    return {};
  }
  const ThreeMfGroup& group = found->second;
  if (group.kind == Kind::other) {
    return {};
  }
  for (const std::uint32_t property : triangle.property) {
    if (property >= group.colors.size()) {
      return fail(ErrorKind::malformed, where(part.name),
                  fmt::format("object {}: property {} of group {} is outside of its {}", id, property, triangle.group, group.colors.size()));
    }
  }
  const auto& [a, b, c] = triangle.property;
  if (group.kind == Kind::base) {
    if (mesh_.materials.size() + group.colors.size() > kMostMaterials) {
      return fail(ErrorKind::limit, where(part.name), fmt::format("more than {} materials", kMostMaterials));
    }
    add_material(part, triangle.group, a);
    return {};
  }
  if (group.alphas[a] < 1 || group.alphas[b] < 1 || group.alphas[c] < 1) {
    part.notes.add(0, "opacities of colours are ignored");
  }
  if (group.colors[a] == group.colors[b] && group.colors[b] == group.colors[c]) {
    mesh_.face_colors.back() = group.colors[a];
    has_face_colors_ = true;
    return {};
  }
  for (std::size_t i = 0; i < 3; ++i) {
    colors[i] = packed(group.colors[triangle.property[i]]);
  }
  has_corner_colors_ = true;
  return {};
}

void Package::add_material(Part& part, std::uint32_t group_id, std::uint32_t property) {
  const ThreeMfGroup& group = part.model.groups.at(group_id);
  const auto [first, is_new] = part.first_material.try_emplace(group_id, static_cast<std::uint32_t>(mesh_.materials.size()));
  for (std::size_t i = 0; is_new && i < group.colors.size(); ++i) {
    Material material;
    material.name = to_utf8(group.names[i]);
    const Vec3f& c = group.colors[i];
    material.diffuse = {c, ColorSpace::encoded};
    material.ambient = {Vec3f{srgb_decode(c.x), srgb_decode(c.y), srgb_decode(c.z)} * 0.25F, ColorSpace::linear};
    material.opacity = group.alphas[i];
    mesh_.materials.push_back(std::move(material));
  }
  mesh_.face_material.back() = first->second + property;
  has_materials_ = true;
}

void Package::finish() {
  // clang-format off
  if (!has_materials_)     { mesh_.face_material.clear(); }
  if (!has_face_colors_)   { mesh_.face_colors.clear(); }
  if (!has_corner_colors_) { mesh_.colors.clear(); }
  // clang-format on
  mesh_.format = "3MF";
  mesh_.notes = notes_.notes();
  for (const auto& [name, part] : parts_) {
    const Notes more = part.notes.notes();
    mesh_.notes.insert(mesh_.notes.end(), more.begin(), more.end());
  }
}

Result<SourceMesh> Package::read() {
  const Result<std::string> name = find_model();
  if (!name) {
    return tl::unexpected(name.error());
  }
  const Result<Part*> root = open_part(*name);
  if (!root) {
    return tl::unexpected(root.error());
  }
  Part& part = **root;
  Size all;
  for (const ThreeMfUse& item : part.model.build) {
    const Result<Size> size = count(item, part, 0);
    if (!size) {
      return tl::unexpected(size.error());
    }
    all.uses += std::max<std::uint64_t>(size->uses, 1);
    all.triangles += size->triangles;
    all.vertices += size->vertices;
    if (all.uses > limits_.uses || all.triangles > limits_.triangles || all.vertices > 3 * limits_.triangles) {
      return fail(ErrorKind::limit, place_of(part, item.line),
                  fmt::format("the build places {} meshes, {} triangles and {} vertices or more, and at most {}, {} and {} are read", all.uses,
                              all.triangles, all.vertices, limits_.uses, limits_.triangles, 3 * limits_.triangles));
    }
  }
  if (part.model.build.empty()) {
    part.notes.add(0, "the build has no items: there is nothing to show");
  }
  Mat4 to_millimetres;
  if (part.model.millimetres != 1) {
    part.notes.add(0, fmt::format("lengths are converted from {} to millimetres", part.model.unit));
    to_millimetres(0, 0) = to_millimetres(1, 1) = to_millimetres(2, 2) = part.model.millimetres;
  }
  for (const ThreeMfUse& item : part.model.build) {
    if (const Result<void> placed = place(item, part, to_millimetres); !placed) {
      return tl::unexpected(placed.error());
    }
  }
  finish();
  return std::move(mesh_);
}

}  // namespace

Result<SourceMesh> parse_threemf(std::string_view bytes, const std::string& file, const ThreeMfLimits& limits) {
  Result<ZipArchive> archive = open_zip(bytes, file);
  if (!archive) {
    return tl::unexpected(archive.error());
  }
  return Package(*std::move(archive), limits).read();
}

}  // namespace lustro
