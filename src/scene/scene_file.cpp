// parse_scene(): the scene file, whose contract is docs/using/scene-file.md. Three steps: the text's tree, its keys one by one, its keys
// together.
#include "lustro/scene.hpp"
#include "scene/check_scene.hpp"
#include "scene/json_document.hpp"
#include "scene/scene_reader.hpp"

namespace lustro {
namespace {

/// `scene.json: lights[2].cutoff`
Error in_file(Error error, const std::string& file) {
  error.where = error.where.empty() ? file : file + ": " + error.where;
  return error;
}

}  // namespace

Result<Scene> parse_scene(std::string_view text, const std::string& file) {
  const auto document = parse_json(text, file);
  if (!document) {
    return tl::unexpected(document.error());
  }
  auto scene = read_scene(*document);
  if (!scene) {
    return tl::unexpected(in_file(scene.error(), file));
  }
  if (const auto done = check_scene(*scene); !done) {
    return tl::unexpected(in_file(done.error(), file));
  }
  return scene;
}

}  // namespace lustro
