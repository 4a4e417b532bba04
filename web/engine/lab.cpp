// The scene that the page shows, drawn and explained: see lab.hpp.
#include "lab.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "app/explain_report.hpp"
#include "command_text.hpp"
#include "scene/check_scene.hpp"
#include "shade/glsl.hpp"

namespace lustro::web {
namespace {

namespace fs = std::filesystem;
using app::json_number;
using app::json_vector;

/// All of a scene's text that shapes the meshes themselves.
std::string mesh_key_of(const Json& scene) {
  Json key;
  if (const auto shading = scene.find("shading"); shading != scene.end() && shading->is_object()) {
    for (const char* name : {"vertex_normals", "crease", "recompute_normals"}) {
      key[name] = shading->value(name, Json());
    }
  }
  if (const auto image = scene.find("image"); image != scene.end() && image->is_object()) {
    key["transfer"] = image->value("transfer", Json());
  }
  return key.dump();
}

/// All of it that shapes what load_meshes() makes.
std::string load_key_of(const Json& scene) {
  Json key;
  for (const char* name : {"objects", "materials", "environment"}) {
    key[name] = scene.value(name, Json());
  }
  return key.dump() + mesh_key_of(scene);
}

/// The meshes that are there already, where they are the same.
void keep_meshes(const Scene& before, Scene& after) {
  for (Object& object : after.objects) {
    const auto same = std::find_if(before.objects.begin(), before.objects.end(), [&](const Object& old) { return old.source == object.source; });
    if (same != before.objects.end()) {
      object.mesh = same->mesh;
    }
  }
}

/// A point by a matrix.
Vec3d transformed(const Mat4& m, const Vec3d& p) {
  const auto row = [&](int i) { return m(i, 0) * p.x + m(i, 1) * p.y + m(i, 2) * p.z + m(i, 3); };
  return {row(0), row(1), row(2)};
}

/// The box of an object's box where it stands.
Bounds world_bounds(const Object& object) {
  Bounds bounds;
  const Bounds stated = object.mesh->bounds();
  for (unsigned corner = 0; corner < 8 && !stated.is_empty(); ++corner) {
    const Vec3d p{(corner & 1U) != 0 ? stated.upper.x : stated.lower.x, (corner & 2U) != 0 ? stated.upper.y : stated.lower.y,
                  (corner & 4U) != 0 ? stated.upper.z : stated.lower.z};
    bounds.include(transformed(object.matrix, p));
  }
  return bounds;
}

Json times_answer(const RenderTimes& times) {
  return {{"prepare", json_number(times.prepare)},       {"shadows", json_number(times.shadows)}, {"cull", json_number(times.cull)},
          {"visibility", json_number(times.visibility)}, {"shading", json_number(times.shading)}, {"total", json_number(times.total)}};
}

/// The triangle that the pixel shows first, in the world.
Json triangle_json(const Scene& scene, const FragmentExplanation& fragment) {
  const Object& object = scene.objects.at(static_cast<std::size_t>(fragment.object));
  const Mesh& mesh = *object.mesh;
  const auto index = static_cast<std::size_t>(fragment.triangle);
  if (index >= mesh.triangles.size()) {
    return nullptr;  // of a displaced mesh
  }
  const Mat4& m = object.matrix;
  // The cofactors of the matrix turn normals, up to a factor whose sign is that of the determinant.
  const auto column = [&](int i) { return Vec3d{m(0, i), m(1, i), m(2, i)}; };
  const std::array<Vec3d, 3> cofactors{cross(column(1), column(2)), cross(column(2), column(0)), cross(column(0), column(1))};
  const double sign = dot(column(0), cofactors[0]) < 0 ? -1.0 : 1.0;
  Json positions = Json::array();
  Json normals = Json::array();
  std::array<Vec3d, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i] = transformed(m, vec_cast<double>(mesh.positions[mesh.triangles[index][i]]));
    positions.push_back(json_vector(corners[i]));
  }
  const Vec3d face = cross(corners[1] - corners[0], corners[2] - corners[0]) * sign;
  for (std::size_t i = 0; i < 3; ++i) {
    Vec3d normal = face;
    if (!mesh.normals.empty()) {
      const auto n = vec_cast<double>(mesh.normals[mesh.triangles[index][i]]);
      normal = (cofactors[0] * n.x + cofactors[1] * n.y + cofactors[2] * n.z) * sign;
    }
    normals.push_back(json_vector(normalize(normal)));
  }
  return {{"positions", std::move(positions)}, {"normals", std::move(normals)}};
}

}  // namespace

std::string Lab::open(const std::string& entry) {
  const fs::path file = fs::path(kFiles) / entry;
  const auto loaded = load_scene(file);
  if (!loaded) {
    return error_answer(loaded.error());
  }
  folder_ = file.parent_path().string();
  entry_ = entry;
  opened_ = loaded->scene;
  scene_ = loaded->scene;
  text_ = scene_json(scene_);
  load_notes_ = {};  // told below, once
  Json json = Json::parse(text_);
  note_load(json);
  return answer(
      {{"scene", std::move(json)}, {"notes", note_list(loaded->notes)}, {"cameras", loaded->cameras}, {"animations", loaded->animations}});
}

Result<const Scene*> Lab::scene_of(const std::string& text) {
  if (text == text_) {
    return &scene_;
  }
  auto parsed = parse_scene(text);
  if (!parsed) {
    return tl::unexpected(parsed.error());
  }
  const Json json = Json::parse(text);
  const bool is_new = load_key_of(json) != load_key_;
  if (!is_new) {
    parsed->objects = std::move(scene_.objects);
    parsed->environment = std::move(scene_.environment);
  } else {
    if (mesh_key_of(json) == mesh_key_) {
      keep_meshes(scene_, *parsed);
    }
    auto notes = load_meshes(*parsed, folder_);
    if (!notes) {
      return tl::unexpected(notes.error());
    }
    load_notes_ = *std::move(notes);
  }
  scene_ = *std::move(parsed);
  text_ = text;
  if (is_new) {
    note_load(json);
  }
  return &scene_;
}

void Lab::note_load(const Json& json) {
  ++generation_;
  load_key_ = load_key_of(json);
  mesh_key_ = mesh_key_of(json);
  bounds_ = {};
  for (const Object& object : scene_.objects) {
    if (const Bounds part = world_bounds(object); !part.is_empty()) {
      bounds_.include(part.lower);
      bounds_.include(part.upper);
    }
  }
}

Result<Scene> Lab::scene_of(const PictureRequest& request) {
  const auto found = scene_of(request.scene);
  if (!found) {
    return tl::unexpected(found.error());
  }
  Scene scene = **found;
  scene.image.width = request.width > 0 ? request.width : scene.image.width;
  scene.image.height = request.height > 0 ? request.height : scene.image.height;
  scene.image.samples = request.samples > 0 ? request.samples : scene.image.samples;
  if (const auto done = check_scene(scene); !done) {
    return tl::unexpected(done.error());
  }
  return scene;
}

std::string Lab::render(const PictureRequest& request, const PictureWants& wants, int share, int shares) {
  const auto scene = scene_of(request);
  if (!scene) {
    return error_answer(scene.error());
  }
  const RenderOptions options{.threads = 1, .store_color = wants.floats || wants.hash, .store_bytes = true, .share = {share, shares}};
  if (const auto done = renderer_.render(*scene, options, rendering_); !done) {
    return error_answer(done.error());
  }
  Json bands = Json::array();
  for (const Band& band : rendering_.bands) {
    bands.push_back({band.begin, band.end});
  }
  Notes notes = load_notes_;
  notes.insert(notes.end(), rendering_.notes.begin(), rendering_.notes.end());
  Json json{
      {"width", rendering_.bytes.width},         {"height", rendering_.bytes.height},       {"bands", std::move(bands)},
      {"times", times_answer(rendering_.times)}, {"triangles", rendering_.stats.triangles}, {"pixelsCovered", rendering_.stats.pixels_covered}};
  if (wants.hash) {
    json["hash"] = fmt::format("{:016x}", hash_image(rendering_.color));
  }
  if (share == 0) {
    json["view"] = view_answer(rendering_.camera, scene->image);
    json["view"]["lower"] = json_vector(bounds_.is_empty() ? Vec3d{} : bounds_.lower);
    json["view"]["upper"] = json_vector(bounds_.is_empty() ? Vec3d{} : bounds_.upper);
    json["lights"] = light_list(rendering_.lights);
    json["notes"] = note_list(notes);
  }
  return answer(json);
}

std::string Lab::explain(const PictureRequest& request, int x, int y) {
  const auto scene = scene_of(request);
  if (!scene) {
    return error_answer(scene.error());
  }
  const auto explanation = lustro::explain(*scene, x, y);
  if (!explanation) {
    return error_answer(explanation.error());
  }
  Json json = app::explanation_json(*explanation);
  if (!explanation->fragments.empty()) {
    if (Json triangle = triangle_json(*scene, explanation->fragments.front()); !triangle.is_null()) {
      json["triangle"] = std::move(triangle);
    }
  }
  return answer(json);
}

std::string Lab::meshes(const std::string& text) {
  const auto scene = scene_of(text);
  if (!scene) {
    return error_answer(scene.error());
  }
  Json list = Json::array();
  for (const Object& object : (*scene)->objects) {
    const Mesh& mesh = *object.mesh;
    const Bounds bounds = world_bounds(object);
    Json materials = Json::array();
    for (const Material& material : mesh.materials) {
      materials.push_back({{"name", material.name}, {"table", material_table(material)}});
    }
    list.push_back({{"name", object.name.empty() ? object.source : object.name},
                    {"vertices", mesh.positions.size()},
                    {"triangles", mesh.triangles.size()},
                    {"lower", json_vector(bounds.is_empty() ? Vec3d{} : bounds.lower)},
                    {"upper", json_vector(bounds.is_empty() ? Vec3d{} : bounds.upper)},
                    {"hasUvs", !mesh.uvs.empty()},
                    {"hasColors", !mesh.colors.empty()},
                    {"materials", std::move(materials)}});
  }
  return answer(list);
}

std::string Lab::scene_file(const std::string& text) {
  const auto scene = parse_scene(text);
  return scene ? answer({{"text", scene_json(*scene)}}) : error_answer(scene.error());
}

std::string Lab::command_line(const PictureRequest& request) {
  const auto scene = scene_of(request);
  if (!scene) {
    return error_answer(scene.error());
  }
  std::optional<std::string> command;
  if (opened_ && !entry_.empty()) {
    command = command_text(fs::path(entry_).filename().string(), *opened_, *scene, "picture.png");
  }
  if (!command && scene->objects.size() == 1 && scene->objects.front().source.starts_with("primitive:")) {
    Scene base;
    base.shading.two_sided = true;
    base.objects.push_back({.source = scene->objects.front().source, .mesh = scene->objects.front().mesh});
    command = command_text(base.objects.front().source, base, *scene, "picture.png");
  }
  if (command) {
    return answer({{"command", *command}});
  }
  return answer({{"command", "lustro render scene.json -o picture.png"}, {"file", scene_json(*scene)}});
}

std::string Lab::glsl(const std::string& text) {
  const auto scene = parse_scene(text);
  if (!scene) {
    return error_answer(scene.error());
  }
  const Shading& shading = scene->shading;
  const GlslOptions options{.lighting = shading.lighting,
                            .interpolation = shading.interpolation,
                            .projection = scene->camera.projection,
                            .terms = shading.terms,
                            .two_sided = shading.two_sided,
                            .normalized = shading.normalized,
                            .fog = scene->fog.has_value(),
                            .transfer = scene->image.transfer};
  return answer({{"vertex", glsl_shader(GlslStage::vertex, options)}, {"fragment", glsl_shader(GlslStage::fragment, options)}});
}

}  // namespace lustro::web
