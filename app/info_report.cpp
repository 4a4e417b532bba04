// Reports on meshes and scenes: see info_report.hpp.
#include "info_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "report.hpp"
#include "scene/add_note.hpp"
#include "scene/text_values.hpp"
#include "scene/words.hpp"
#include "texture/slots.hpp"
#include "texture/texture.hpp"

namespace lustro::app {
namespace {

std::string row(const char* name, const std::string& value) {
  return fmt::format("  {:<12}{}\n", name, printable(value));
}

std::string vector_text(const Vec3d& v) {
  return fmt::format("{:.6g}, {:.6g}, {:.6g}", v.x, v.y, v.z);
}

std::string bounds_rows(const Bounds& bounds) {
  if (bounds.is_empty()) {
    return row("bounds", "none: there is no triangle");
  }
  const Vec3d size = bounds.upper - bounds.lower;
  return row("bounds", fmt::format("({})  to  ({})", vector_text(bounds.lower), vector_text(bounds.upper))) +
         row("size", fmt::format("{:.6g} x {:.6g} x {:.6g}", size.x, size.y, size.z)) + row("centre", vector_text(bounds.center()));
}

std::string normals_of(const SourceMesh& source) {
  const auto given = static_cast<std::size_t>(
      std::count_if(source.corner_normal.begin(), source.corner_normal.end(), [](std::uint32_t n) { return n != SourceMesh::kNone; }));
  return given == 0                               ? "none in the file: made from the faces"
         : given == source.corner_position.size() ? "in the file"
                                                  : "in the file for some corners";
}

std::string stated_row(const SourceMesh& source) {
  std::string text = counted(source.positions.size(), "vertex", "vertices") + ", " + counted(source.face_count(), "face", "faces");
  if (source.stated_triangle_count() != source.face_count()) {
    text += fmt::format(" ({})", counted(source.stated_triangle_count(), "triangle", "triangles"));
  }
  for (const auto& [count, one, many] : {std::tuple{source.normals.size(), "normal", "normals"}, std::tuple{source.uvs.size(), "uv", "uvs"},
                                         std::tuple{source.colors.size(), "vertex colour", "vertex colours"},
                                         std::tuple{source.face_colors.size(), "face colour", "face colours"}}) {
    if (count > 0) {
      text += ", " + counted(count, one, many);
    }
  }
  return row("stated", text);
}

std::string surface_row(const MeshStats& stats) {
  if (stats.edges == 0) {
    return {};
  }
  std::string text = stats.is_closed() ? "closed" : "open";
  text += fmt::format(", {}, {}", counted(stats.pieces, "piece", "pieces"), counted(stats.edges, "edge", "edges"));
  if (stats.boundary_edges > 0) {
    text += fmt::format(", {} of one triangle only", grouped(stats.boundary_edges));
  }
  if (stats.nonmanifold_edges > 0) {
    text += fmt::format(", {} of more than two", grouped(stats.nonmanifold_edges));
  }
  if (stats.misoriented_edges > 0) {
    text += fmt::format(", {} between faces wound against each other", grouped(stats.misoriented_edges));
  }
  text += fmt::format("; area {:.6g}", stats.area);
  if (stats.is_closed() && stats.is_oriented()) {
    text += fmt::format(", volume {:.6g}{}", std::abs(stats.volume), stats.volume < 0 ? " (wound inside out)" : "");
  }
  return row("surface", text);
}

std::string material_rows(const std::vector<Material>& materials) {
  std::string text = row("materials", materials.empty() ? std::string("none") : grouped(materials.size()));
  for (const Material& material : materials) {
    text += fmt::format("    {}\n", printable(material.name.empty() ? "(no name)" : material.name));
    text += fmt::format("      ambient {}  diffuse {}  specular {}  emission {}  shininess {}  opacity {}\n", color_text(material.ambient),
                        color_text(material.diffuse), color_text(material.specular), color_text(material.emission),
                        number_text(material.shininess), number_text(material.opacity));
    if (material.lighting || material.illumination) {
      text += fmt::format("      lighting {}{}\n", material.lighting ? word_of(*material.lighting) : "the scene's",
                          material.illumination ? fmt::format(" (illum {})", *material.illumination) : "");
    }
    for (const TextureMap& map : material.maps) {
      text += fmt::format("      {} {}\n", map.statement, printable(map.file));
    }
  }
  return text;
}

/// `cameras  2: 0 front, 1 (no name)`
std::string names_row(const char* what, const std::vector<std::string>& names) {
  if (names.empty()) {
    return row(what, "none");
  }
  std::string text = grouped(names.size()) + ":";
  constexpr std::size_t kMost = 20;
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i) {
    text += fmt::format("{} {} {}", i == 0 ? "" : ",", i, names[i].empty() ? "(no name)" : names[i]);
  }
  return row(what, names.size() > kMost ? text + ", ..." : text);
}

/// A picture and what it is used for: `red: diffuse`.
struct TextureRow {
  std::string file;
  const Texture* texture = nullptr;
  std::vector<std::string> uses;
};

/// The textures of materials, each picture once, in the order of its first use.
std::vector<TextureRow> texture_rows(const std::vector<Material>& materials) {
  std::vector<TextureRow> rows;
  for (const Material& material : materials) {
    const auto add = [&](const std::optional<TextureUse>& use, std::string_view key) {
      if (!use || !use->texture) {
        return;
      }
      auto found = std::ranges::find(rows, use->texture.get(), &TextureRow::texture);
      if (found == rows.end()) {
        rows.push_back({use->name, use->texture.get(), {}});
        found = rows.end() - 1;
      }
      const std::string user = fmt::format("{}: {}", material.name.empty() ? "(no name)" : material.name, key);
      if (std::ranges::find(found->uses, user) == found->uses.end()) {  // objects may share a material
        found->uses.push_back(user);
      }
    };
    for (const TextureSlot& slot : kTextureSlots) {
      add(material.textures.*slot.use, slot.key);
    }
    if (const std::optional<ReflectionMap>& map = material.textures.reflection) {
      for (std::size_t face = 0; face < kCubeFaces.size(); ++face) {
        add(map->faces[face], map->shape == ReflectionShape::cube ? fmt::format("reflection {}", kCubeFaces[face]) : "reflection");
      }
    }
  }
  return rows;
}

std::string texture_text(const std::vector<Material>& materials) {
  const std::vector<TextureRow> rows = texture_rows(materials);
  std::string text = rows.empty() ? "" : row("textures", grouped(rows.size()));
  for (const TextureRow& texture : rows) {
    text += fmt::format("    {}  {} x {}, {}\n", printable(texture.file), texture.texture->width(), texture.texture->height(),
                        counted(static_cast<std::uint64_t>(texture.texture->channels()), "channel", "channels"));
    for (const std::string& use : texture.uses) {
      text += fmt::format("      {}\n", printable(use));
    }
  }
  return text;
}

Json textures_json(const std::vector<Material>& materials) {
  Json json = Json::array();
  for (const TextureRow& texture : texture_rows(materials)) {
    json.push_back({{"file", texture.file},
                    {"width", texture.texture->width()},
                    {"height", texture.texture->height()},
                    {"channels", texture.texture->channels()},
                    {"used_by", texture.uses}});
  }
  return json;
}

/// What the objects of a scene are made of.
std::vector<Material> drawn_materials(const Scene& scene) {
  std::vector<Material> materials;
  std::set<const Mesh*> seen;
  for (const Object& object : scene.objects) {
    if (object.material) {
      materials.push_back(*object.material);
    } else if (object.mesh && seen.insert(object.mesh.get()).second) {
      materials.insert(materials.end(), object.mesh->materials.begin(), object.mesh->materials.end());
    }
  }
  return materials;
}

std::string note_rows(const char* name, const Notes& notes) {
  std::string text;
  for (const Note& note : notes) {
    text += row(text.empty() ? name : "", note.text());
  }
  return text;
}

Notes all_notes(const MeshReport& report) {
  Notes notes = report.source->notes;
  for (const Note& note : report.built->notes) {
    add_note(notes, note);
  }
  return notes;
}

Json stats_json(const MeshStats& stats) {
  return {{"closed", stats.is_closed()},
          {"oriented", stats.is_oriented()},
          {"pieces", stats.pieces},
          {"positions", stats.positions},
          {"edges", stats.edges},
          {"boundary_edges", stats.boundary_edges},
          {"nonmanifold_edges", stats.nonmanifold_edges},
          {"misoriented_edges", stats.misoriented_edges},
          {"area", json_number(stats.area)},
          {"volume", stats.is_closed() && stats.is_oriented() ? json_number(stats.volume) : Json(nullptr)}};
}

Json materials_json(const std::vector<Material>& materials) {
  Json json = Json::array();
  for (const Material& material : materials) {
    json.push_back(json_material(material));
  }
  return json;
}

/// The box around a mesh at its place: of the eight corners of its own box.
Bounds placed(const Bounds& bounds, const Mat4& matrix) {
  Bounds result;
  for (int corner = 0; corner < 8 && !bounds.is_empty(); ++corner) {
    result.include(
        transform_point(matrix, {(corner & 1) != 0 ? bounds.upper.x : bounds.lower.x, (corner & 2) != 0 ? bounds.upper.y : bounds.lower.y,
                                 (corner & 4) != 0 ? bounds.upper.z : bounds.lower.z}));
  }
  return result;
}

Bounds scene_bounds(const Scene& scene) {
  Bounds bounds;
  for (const Object& object : scene.objects) {
    if (const Bounds box = object.mesh ? placed(object.mesh->bounds(), object.matrix) : Bounds{}; !box.is_empty()) {
      bounds.include(box.lower);
      bounds.include(box.upper);
    }
  }
  return bounds;
}

}  // namespace

MeshReport make_mesh_report(const std::string& file, const SourceMesh& source, const BuiltMesh& built) {
  return {file, &source, &built, mesh_stats(built.mesh), nullptr};
}

std::string mesh_text(const MeshReport& report) {
  const SourceMesh& source = *report.source;
  const Mesh& mesh = report.built->mesh;
  std::string text = printable(report.file) + "\n" + row("format", source.format) + stated_row(source);
  text += row("normals", normals_of(source));
  text += row("drawn", counted(mesh.positions.size(), "vertex", "vertices") + ", " + counted(mesh.triangles.size(), "triangle", "triangles"));
  text += bounds_rows(mesh.bounds()) + surface_row(report.stats);
  text += row("objects", source.objects.empty() ? std::string("none named") : grouped(source.objects.size()));
  for (std::size_t i = 0; i < source.objects.size(); ++i) {
    constexpr std::size_t kMost = 20;
    if (i == kMost) {
      text += fmt::format("    ... and {} more\n", source.objects.size() - kMost);
      break;
    }
    text += fmt::format("    {}\n", printable(source.objects[i].empty() ? "(no name)" : source.objects[i]));
  }
  text += material_rows(source.materials) + texture_text(source.materials);
  if (report.scene != nullptr) {
    text += names_row("cameras", report.scene->cameras) + names_row("animations", report.scene->animations);
    text +=
        row("lights", report.scene->scene.lights ? grouped(report.scene->scene.lights->size()) : std::string("none stated: the default rig"));
  }
  return text + note_rows("noticed", all_notes(report));
}

Json mesh_json(const MeshReport& report) {
  const SourceMesh& source = *report.source;
  const Mesh& mesh = report.built->mesh;
  Json json{{"file", report.file},
            {"kind", "mesh"},
            {"format", source.format},
            {"stated",
             {{"vertices", source.positions.size()},
              {"faces", source.face_count()},
              {"triangles", source.stated_triangle_count()},
              {"normals", source.normals.size()},
              {"uvs", source.uvs.size()},
              {"vertex_colors", source.colors.size()},
              {"face_colors", source.face_colors.size()}}},
            {"drawn", {{"vertices", mesh.positions.size()}, {"triangles", mesh.triangles.size()}}},
            {"bounds", json_bounds(mesh.bounds())},
            {"surface", stats_json(report.stats)},
            {"objects", source.objects},
            {"materials", materials_json(source.materials)},
            {"textures", textures_json(source.materials)},
            {"notes", json_notes(all_notes(report))}};
  if (report.scene != nullptr) {
    json["cameras"] = report.scene->cameras;
    json["animations"] = report.scene->animations;
  }
  return json;
}

std::string scene_info_text(const std::string& file, const LoadedScene& loaded) {
  const Scene& scene = loaded.scene;
  std::string text = printable(file) + "\n" + row("format", "scene");
  text += row("picture", fmt::format("{} x {}, {} samples, transfer {}", scene.image.width, scene.image.height, scene.image.samples,
                                     word_of(scene.image.transfer)));
  text += row("camera", fmt::format("{}, {}", word_of(scene.camera.projection),
                                    scene.camera.eye ? fmt::format("eye at ({})", vector_text(*scene.camera.eye))
                                                     : fmt::format("frames everything, view {}", word_of(scene.camera.view))));
  text += row("shading", fmt::format("lighting {}, interpolation {}", word_of(scene.shading.lighting), word_of(scene.shading.interpolation)));
  text += row("lights", !scene.lights ? std::string("none stated: the default rig") : grouped(scene.lights->size()));
  if (scene.lights) {
    for (std::size_t i = 0; i < scene.lights->size(); ++i) {
      const Light& light = (*scene.lights)[i];
      text += fmt::format("    {} {}{}\n", i, word_of(light.type), light.name.empty() ? "" : " " + printable(light.name));
    }
  }
  text += bounds_rows(scene_bounds(scene));
  text += row("objects", grouped(scene.objects.size()));
  for (const Object& object : scene.objects) {
    const std::uint64_t triangles = object.mesh ? object.mesh->triangles.size() : 0;
    const std::uint64_t vertices = object.mesh ? object.mesh->positions.size() : 0;
    text += fmt::format(
        "    {}: {}, {}{}\n", printable(object.name.empty() ? object.source : object.name + " (" + object.source + ")"),
        counted(vertices, "vertex", "vertices"), counted(triangles, "triangle", "triangles"),
        object.material ? fmt::format(", material {}", printable(object.material->name.empty() ? "of its own" : object.material->name)) : "");
  }
  return text + texture_text(drawn_materials(scene)) + note_rows("noticed", loaded.notes);
}

Json scene_info_json(const std::string& file, const LoadedScene& loaded) {
  const Scene& scene = loaded.scene;
  Json objects = Json::array();
  std::uint64_t triangles = 0;
  for (const Object& object : scene.objects) {
    Json json{{"name", object.name}, {"mesh", object.source}};
    if (object.mesh) {
      triangles += object.mesh->triangles.size();
      json["vertices"] = object.mesh->positions.size();
      json["triangles"] = object.mesh->triangles.size();
      json["bounds"] = json_bounds(placed(object.mesh->bounds(), object.matrix));
      json["materials"] = object.material ? materials_json({*object.material}) : materials_json(object.mesh->materials);
    }
    objects.push_back(std::move(json));
  }
  Json lights = nullptr;  // the default rig
  if (scene.lights) {
    lights = Json::array();
    for (const Light& light : *scene.lights) {
      lights.push_back({{"type", word_of(light.type)}, {"name", light.name}});
    }
  }
  return {{"file", file},
          {"kind", "scene"},
          {"width", scene.image.width},
          {"height", scene.image.height},
          {"samples", scene.image.samples},
          {"projection", word_of(scene.camera.projection)},
          {"lighting", word_of(scene.shading.lighting)},
          {"interpolation", word_of(scene.shading.interpolation)},
          {"triangles", triangles},
          {"bounds", json_bounds(scene_bounds(scene))},
          {"lights", lights},
          {"objects", objects},
          {"textures", textures_json(drawn_materials(scene))},
          {"notes", json_notes(loaded.notes)}};
}

}  // namespace lustro::app
