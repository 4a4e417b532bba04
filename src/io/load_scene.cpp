// Scenes with their meshes: a scene file or a bare mesh file, told apart by content; each mesh file read once, whatever the number of objects.
#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cstdio>
#include <exception>
#include <map>
#include <memory>
#include <new>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "io/find_file.hpp"
#include "io/gltf_scene.hpp"
#include "io/load_environment.hpp"
#include "io/load_mesh.hpp"
#include "io/load_textures.hpp"
#include "io/mesh_format.hpp"
#include "io/read_file.hpp"
#include "io/text.hpp"
#include "lustro/scene.hpp"
#include "scene/check_scene.hpp"
#include "scene/json_document.hpp"

namespace lustro {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPrimitive = "primitive:";
constexpr double kSmooth = 180;
constexpr double kCreaseOfFacets = 40;  // STL knows no shared vertices: its welded edges are smooth up to here

/// `outer: inner`, where either may be missing.
std::string joined(std::string_view outer, std::string_view inner) {
  return outer.empty() || inner.empty() ? fmt::format("{}{}", outer, inner) : fmt::format("{}: {}", outer, inner);
}

/// Notes in the order in which they came, each once.
class NoteList {
 public:
  void add(Note note) {
    if (seen_.emplace(note.where, note.message).second) {
      notes_.push_back(std::move(note));
    }
  }
  [[nodiscard]] Notes take() { return std::move(notes_); }

 private:
  Notes notes_;
  std::set<std::pair<std::string, std::string>> seen_;
};

bool is_primitive(std::string_view source) {
  return source.starts_with(kPrimitive);
}

/// One name for one mesh, however the objects write its path.
std::string identity_of_source(const std::string& source, const fs::path& file) {
  return is_primitive(source) ? source : identity_of(file);
}

Result<BuiltMesh> build(ReadMesh read, const NormalOptions& normals, int threads) {
  PlainMesh* const plain = std::get_if<PlainMesh>(&read);
  if (plain == nullptr) {
    return build_mesh(std::get<SourceMesh>(std::move(read)), normals, threads);
  }
  return makes_plain_normals(normals) ? build_plain(std::move(*plain), normals, threads)
                                      : build_mesh(to_source(std::move(*plain)), normals, threads);
}

/// What was read, ready for drawing.
Result<std::shared_ptr<const Mesh>> build_read(ReadMesh read, const std::string& name, const Shading& shading, const LoadOptions& options,
                                               NoteList& notes) {
  const auto* const plain = std::get_if<PlainMesh>(&read);
  NormalOptions normals;
  normals.weights = shading.vertex_normals;
  normals.crease_deg = shading.crease.value_or(plain == nullptr && std::get<SourceMesh>(read).weld_first ? kCreaseOfFacets : kSmooth);
  normals.recompute = shading.recompute_normals;
  for (const Note& note : plain != nullptr ? plain->notes : std::get<SourceMesh>(read).notes) {
    notes.add({note.where.empty() ? name : note.where, note.message});
  }
  Result<BuiltMesh> built = build(std::move(read), normals, options.threads);
  if (!built) {
    return fail(built.error().kind, joined(name, built.error().where), built.error().message);
  }
  for (const Note& note : built->notes) {
    notes.add({joined(name, note.where), note.message});
  }
  return std::make_shared<const Mesh>(std::move(built->mesh));
}

/// The mesh that a `source` names.
Result<ReadMesh> read_source(const std::string& source, const fs::path& file, const Shading& shading, const LoadOptions& options,
                             TextureCache& textures) {
  if (is_primitive(source)) {
    return make_primitive(std::string_view(source).substr(kPrimitive.size())).map([](SourceMesh&& made) { return ReadMesh(std::move(made)); });
  }
  return read_mesh_file(file, options, shading.crease.value_or(kSmooth) == kSmooth, textures);
}

/// A source that names a node of a glTF file: `duck.glb#nodes[2]`.
struct NodeSource {
  std::string file;
  std::size_t node = 0;
};

std::optional<NodeSource> node_source(const std::string& source, const fs::path& folder) {
  constexpr std::string_view kNode = "#nodes[";
  const std::size_t mark = source.rfind(kNode);
  if (mark == std::string::npos || !source.ends_with(']')) {
    return std::nullopt;
  }
  NodeSource found{source.substr(0, mark)};
  const char* const end = source.data() + source.size() - 1;
  const auto [stop, error] = std::from_chars(source.data() + mark + kNode.size(), end, found.node);
  std::error_code ignored;
  if (error != std::errc() || stop != end || fs::exists(folder / fs::path(source), ignored)) {
    return std::nullopt;
  }
  return found;
}

/// Meshes, glTF files and pictures by the identity of their file, each read once.
struct Loaded {
  std::map<std::string, std::shared_ptr<const Mesh>> meshes;
  std::map<std::string, GltfModel> models;
  std::set<std::string> textured_models;
  TextureCache textures;
};

/// Reads the pictures of all nodes of the file that the scene shows.
Result<void> read_all_textures(GltfModel& model, const std::string& identity, const Scene& scene, const fs::path& folder,
                               const LoadOptions& options) {
  std::vector<std::size_t> nodes;
  std::map<std::string, bool> is_this;  // as the objects write the file's name
  for (const Object& object : scene.objects) {
    const std::optional<NodeSource> node = object.mesh == nullptr ? node_source(object.source, folder) : std::nullopt;
    if (!node) {
      continue;
    }
    const auto [known, is_new] = is_this.try_emplace(node->file);
    if (is_new) {
      known->second = identity_of(folder / fs::path(node->file)) == identity;
    }
    if (known->second) {
      nodes.push_back(node->node);
    }
  }
  return read_gltf_textures(model, nodes, options);
}

/// The mesh of a node, with those of the file's other nodes that have the same.
Result<std::shared_ptr<const Mesh>> load_node(const NodeSource& source, const fs::path& folder, const Scene& scene, const LoadOptions& options,
                                              Loaded& loaded, NoteList& notes) {
  const fs::path file = folder / fs::path(source.file);
  const std::string identity = identity_of(file);
  auto model = loaded.models.find(identity);
  if (model == loaded.models.end()) {
    Result<GltfModel> read = load_gltf(file, options);
    if (!read) {
      return tl::unexpected(std::move(read).error());
    }
    model = loaded.models.emplace(identity, std::move(*read)).first;
  }
  if (loaded.textured_models.insert(identity).second) {
    if (const Result<void> done = read_all_textures(model->second, identity, scene, folder, options); !done) {
      return tl::unexpected(done.error());
    }
  }
  std::shared_ptr<const Mesh>& mesh = loaded.meshes[identity + "#" + gltf_mesh_key(model->second, source.node)];
  if (mesh == nullptr) {
    Result<SourceMesh> read = gltf_node_mesh(model->second, source.node, options);
    if (!read) {
      return tl::unexpected(std::move(read).error());
    }
    auto built = build_read(std::move(*read), file.string(), scene.shading, options, notes);
    if (!built) {
      return tl::unexpected(std::move(built).error());
    }
    mesh = std::move(*built);
  }
  return mesh;
}

/// The mesh of an object, by its source.
Result<std::shared_ptr<const Mesh>> load_source(const std::string& source, const fs::path& folder, const Scene& scene,
                                                const LoadOptions& options, Loaded& loaded, NoteList& notes) {
  if (const std::optional<NodeSource> node = node_source(source, folder)) {
    return load_node(*node, folder, scene, options, loaded, notes);
  }
  const fs::path file = folder / fs::path(source);
  if (!is_primitive(source)) {
    tell(options.on_file, file);  // each name of a file that has several
  }
  std::shared_ptr<const Mesh>& mesh = loaded.meshes[identity_of_source(source, file)];
  if (mesh == nullptr) {
    const std::string name = is_primitive(source) ? source : file.string();
    Result<ReadMesh> read = read_source(source, file, scene.shading, options, loaded.textures);
    if (!read) {
      const Error& error = read.error();
      return fail(error.kind, error.where.empty() ? name : error.where, error.message);
    }
    auto built = build_read(std::move(*read), name, scene.shading, options, notes);
    if (!built) {
      return tl::unexpected(std::move(built).error());
    }
    mesh = std::move(*built);
  }
  return mesh;
}

/// load_meshes(); `with_path` puts the object's JSON path in front of an error.
Result<void> load_all(Scene& scene, const fs::path& folder, const LoadOptions& stated_options, Loaded& loaded, NoteList& notes, bool with_path) {
  LoadOptions options = stated_options;
  options.transfer = scene.image.transfer;
  if (scene.shading.lighting == Lighting::ggx) {
    options.gltf_shading = GltfShading::ggx;
  }
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    Object& object = scene.objects[i];
    if (object.mesh != nullptr) {
      continue;
    }
    const std::string path = with_path ? fmt::format("objects[{}].mesh", i) : "";
    if (object.source.empty()) {
      return fail(ErrorKind::usage, path, "is missing, expected a mesh file or primitive:NAME");
    }
    auto mesh = load_source(object.source, folder, scene, options, loaded, notes);
    if (!mesh) {
      return fail(mesh.error().kind, joined(path, mesh.error().where), mesh.error().message);
    }
    object.mesh = std::move(*mesh);
  }
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    std::optional<Material>& material = scene.objects[i].material;
    if (!material || material->stated_textures == StatedTextures{}) {
      continue;
    }
    const std::string where =
        material->name.empty() ? fmt::format("objects[{}].material.textures", i) : fmt::format("material {}", shown(material->name));
    const Result<Notes> found = load_stated_textures(*material, where, folder, options, loaded.textures);
    if (!found) {
      return tl::unexpected(found.error());
    }
    for (const Note& note : *found) {
      notes.add(note);
    }
  }
  if (scene.environment) {
    const Result<Notes> found = load_environment(*scene.environment, folder, options);
    if (!found) {
      return tl::unexpected(found.error());
    }
    for (const Note& note : *found) {
      notes.add(note);
    }
  }
  return {};
}

/// The first bytes of a regular file; empty for anything else.
std::string head_of(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) {
    return {};
  }
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "rb"), &std::fclose);
  if (stream == nullptr) {
    return {};
  }
  std::array<char, 65536> bytes{};
  return {bytes.data(), std::fread(bytes.data(), 1, bytes.size(), stream.get())};
}

/// Whether a text is a table of JSON, as scene files are, and no mesh is.
bool opens_a_table(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) {
    text.remove_prefix(3);
  }
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '{';
}

/// glTF is JSON, too.
bool is_gltf(const fs::path& file, std::string_view text) {
  return mesh_format_of_name(file) == MeshFormat::gltf ||
         (mesh_format_of_content(text) == MeshFormat::gltf && text.find("\"objects\"") == std::string_view::npos);
}

Result<LoadedScene> load_scene_text(const fs::path& file, std::string_view text, const LoadOptions& options) {
  const std::string name = file.string();
  auto scene = parse_scene(text, name);
  if (!scene) {
    return tl::unexpected(scene.error());
  }
  if (const auto done = options.adjust ? options.adjust(*scene) : Result<void>(); !done) {
    return tl::unexpected(done.error());
  }
  NoteList notes;
  for (const Note& note : unused_keys(*scene)) {
    notes.add({joined(name, note.where), note.message});
  }
  Loaded loaded;
  if (const auto done = load_all(*scene, file.parent_path(), options, loaded, notes, true); !done) {
    return fail(done.error().kind, joined(name, done.error().where), done.error().message);
  }
  return LoadedScene{*std::move(scene), notes.take()};
}

Result<LoadedScene> load_bare_mesh(const fs::path& file, const LoadOptions& options) {
  Scene scene;
  scene.shading.two_sided = true;  // meshes from anywhere are often open, or wound the other way
  Object object;
  object.source = file.filename().string();
  scene.objects.push_back(std::move(object));
  if (const auto done = options.adjust ? options.adjust(scene) : Result<void>(); !done) {
    return tl::unexpected(done.error());
  }
  NoteList notes;
  Loaded loaded;
  if (const auto done = load_all(scene, file.parent_path(), options, loaded, notes, false); !done) {
    return tl::unexpected(done.error());
  }
  return LoadedScene{std::move(scene), notes.take()};
}

Result<LoadedScene> load_gltf_scene(const fs::path& file, const LoadOptions& options) {
  Result<GltfModel> model = load_gltf(file, options);
  if (!model) {
    return tl::unexpected(std::move(model).error());
  }
  const std::string source = file.filename().string();
  Result<LoadedScene> result = gltf_scene(*model, source, options);
  if (!result) {
    return result;
  }
  if (const auto done = options.adjust ? options.adjust(result->scene) : Result<void>(); !done) {
    return tl::unexpected(done.error());
  }
  NoteList notes;
  for (Note& note : result->notes) {
    notes.add(std::move(note));
  }
  Loaded loaded;
  loaded.models.emplace(identity_of(file), std::move(*model));
  if (const auto done = load_all(result->scene, file.parent_path(), options, loaded, notes, false); !done) {
    return tl::unexpected(done.error());
  }
  result->notes = notes.take();
  return result;
}

Result<LoadedScene> load(const fs::path& file, const LoadOptions& options) {
  const std::string head = head_of(file);
  const bool is_named_json = file.extension() == ".json";
  if (head.starts_with("glTF")) {
    return load_gltf_scene(file, options);
  }
  if (!is_named_json && !opens_a_table(head)) {
    return mesh_format_of_name(file) == MeshFormat::gltf || mesh_format_of_name(file) == MeshFormat::glb ? load_gltf_scene(file, options)
                                                                                                         : load_bare_mesh(file, options);
  }
  std::error_code error;
  const auto size = fs::file_size(file, error);
  if (!error && size > JsonLimits{}.bytes) {
    return fail(ErrorKind::limit, file.string(),
                fmt::format("has {} bytes, the largest JSON text that is read has {}", size, JsonLimits{}.bytes));
  }
  tell(options.on_file, file);
  const Result<FileBytes> content = read_file(file);
  if (!content) {
    return tl::unexpected(content.error());
  }
  if (is_gltf(file, content->view())) {
    return load_gltf_scene(file, options);
  }
  return load_scene_text(file, content->view(), options);
}

/// What the system's paths and memory throw, as an error.
template <class F>
auto caught(const std::string& where, F&& f) -> decltype(f()) {
  try {
    return f();
  } catch (const std::bad_alloc&) {
    return fail(ErrorKind::limit, where, "needs more memory than there is");
  } catch (const std::exception& problem) {
    return fail(ErrorKind::io, where, problem.what());
  }
}

}  // namespace

Result<Notes> load_meshes(Scene& scene, const std::filesystem::path& folder, const LoadOptions& options) {
  return caught(folder.string(), [&]() -> Result<Notes> {
    NoteList notes;
    for (const Note& note : unused_keys(scene)) {
      notes.add(note);
    }
    Loaded loaded;
    if (const auto done = load_all(scene, folder, options, loaded, notes, true); !done) {
      return tl::unexpected(done.error());
    }
    return notes.take();
  });
}

Result<LoadedScene> load_scene(const std::filesystem::path& file, const LoadOptions& options) {
  return caught(file.string(), [&] { return load(file, options); });
}

}  // namespace lustro
