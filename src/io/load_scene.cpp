// Scenes with their meshes: a scene file or a bare mesh file, told apart by content; each mesh file read once, whatever the number of objects.
#include <fmt/format.h>

#include <array>
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

#include "io/load_mesh.hpp"
#include "io/mesh_format.hpp"
#include "io/read_file.hpp"
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

/// One name for one file, however the objects write its path.
std::string identity_of(const std::string& source, const fs::path& file) {
  if (is_primitive(source)) {
    return source;
  }
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(file, error);
  return error ? file.string() : canonical.string();
}

Result<BuiltMesh> build(ReadMesh read, const NormalOptions& normals, int threads) {
  PlainMesh* const plain = std::get_if<PlainMesh>(&read);
  if (plain == nullptr) {
    return build_mesh(std::get<SourceMesh>(std::move(read)), normals, threads);
  }
  return makes_plain_normals(normals) ? build_plain(std::move(*plain), normals, threads)
                                      : build_mesh(to_source(std::move(*plain)), normals, threads);
}

/// The mesh that a `source` names, ready for drawing.
Result<std::shared_ptr<const Mesh>> load_source(const std::string& source, const fs::path& file, const Shading& shading,
                                                const LoadOptions& options, NoteList& notes) {
  const std::string name = is_primitive(source) ? source : file.string();
  Result<ReadMesh> read =
      is_primitive(source)
          ? make_primitive(std::string_view(source).substr(kPrimitive.size())).map([](SourceMesh&& made) { return ReadMesh(std::move(made)); })
          : read_mesh_file(file, options, shading.crease.value_or(kSmooth) == kSmooth);
  if (!read) {
    const Error& error = read.error();
    return fail(error.kind, error.where.empty() ? name : error.where, error.message);
  }
  const auto* const plain = std::get_if<PlainMesh>(&*read);
  NormalOptions normals;
  normals.weights = shading.vertex_normals;
  normals.crease_deg = shading.crease.value_or(plain == nullptr && std::get<SourceMesh>(*read).weld_first ? kCreaseOfFacets : kSmooth);
  normals.recompute = shading.recompute_normals;
  for (const Note& note : plain != nullptr ? plain->notes : std::get<SourceMesh>(*read).notes) {
    notes.add({note.where.empty() ? name : note.where, note.message});
  }
  Result<BuiltMesh> built = build(*std::move(read), normals, options.threads);
  if (!built) {
    return fail(built.error().kind, joined(name, built.error().where), built.error().message);
  }
  for (const Note& note : built->notes) {
    notes.add({joined(name, note.where), note.message});
  }
  return std::make_shared<const Mesh>(std::move(built->mesh));
}

/// load_meshes(); `with_path` puts the object's JSON path in front of an error.
Result<void> load_all(Scene& scene, const fs::path& folder, const LoadOptions& options, NoteList& notes, bool with_path) {
  std::map<std::string, std::shared_ptr<const Mesh>> loaded;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    Object& object = scene.objects[i];
    if (object.mesh != nullptr) {
      continue;
    }
    const std::string path = with_path ? fmt::format("objects[{}].mesh", i) : "";
    if (object.source.empty()) {
      return fail(ErrorKind::usage, path, "is missing, expected a mesh file or primitive:NAME");
    }
    const fs::path file = folder / fs::path(object.source);
    std::shared_ptr<const Mesh>& mesh = loaded[identity_of(object.source, file)];
    if (mesh == nullptr) {
      auto read = load_source(object.source, file, scene.shading, options, notes);
      if (!read) {
        return fail(read.error().kind, joined(path, read.error().where), read.error().message);
      }
      mesh = *std::move(read);
    }
    object.mesh = mesh;
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
  if (const auto done = load_all(*scene, file.parent_path(), options, notes, true); !done) {
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
  if (const auto done = load_all(scene, file.parent_path(), options, notes, false); !done) {
    return tl::unexpected(done.error());
  }
  return LoadedScene{std::move(scene), notes.take()};
}

Result<LoadedScene> load(const fs::path& file, const LoadOptions& options) {
  const std::string head = head_of(file);
  const bool is_named_json = file.extension() == ".json";
  if (!is_named_json && !opens_a_table(head)) {
    return load_bare_mesh(file, options);
  }
  std::error_code error;
  const auto size = fs::file_size(file, error);
  if (!error && size > JsonLimits{}.bytes) {
    return fail(ErrorKind::limit, file.string(), fmt::format("has {} bytes, the largest scene file has {}", size, JsonLimits{}.bytes));
  }
  const Result<FileBytes> content = read_file(file);
  if (!content) {
    return tl::unexpected(content.error());
  }
  if (is_gltf(file, content->view())) {
    return load_bare_mesh(file, options);
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
    if (const auto done = load_all(scene, folder, options, notes, true); !done) {
      return tl::unexpected(done.error());
    }
    return notes.take();
  });
}

Result<LoadedScene> load_scene(const std::filesystem::path& file, const LoadOptions& options) {
  return caught(file.string(), [&] { return load(file, options); });
}

}  // namespace lustro
