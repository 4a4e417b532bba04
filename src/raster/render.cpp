// The pipeline's table of contents: from a scene to a picture, one line a stage.
#include "lustro/render.hpp"

#include <fmt/format.h>

#include <chrono>
#include <new>

#include "raster/target.hpp"
#include "reference/render.hpp"
#include "scene/prepare.hpp"

namespace lustro {

struct Renderer::State {
  MeshCache meshes;
};

namespace {

double milliseconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

Result<void> draw(const Scene& scene, const RenderOptions& options, MeshCache& meshes, Rendering& result) {
  const auto begin = std::chrono::steady_clock::now();
  if (auto target = choose_target(options.target); !target) {
    return tl::unexpected(target.error());
  }
  const auto prepared = prepare(scene, meshes, options.threads);  // scene/prepare.cpp
  if (!prepared) {
    return tl::unexpected(prepared.error());
  }
  result.notes = prepared->notes;
  result.times = {};
  result.times.prepare = milliseconds_since(begin);
  if (auto drawn = render_reference(*prepared, options, result); !drawn) {
    return drawn;
  }
  result.times.total = milliseconds_since(begin);
  return {};
}

}  // namespace

Renderer::Renderer() : state_(std::make_unique<State>()) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Result<void> Renderer::render(const Scene& scene, const RenderOptions& options, Rendering& result) {
  try {
    return draw(scene, options, state_->meshes, result);
  } catch (const std::bad_alloc&) {
    return fail(ErrorKind::limit, "", fmt::format("not enough memory to draw {} x {} pixels", scene.image.width, scene.image.height));
  }
}

Result<Rendering> render(const Scene& scene, const RenderOptions& options) {
  Rendering result;
  Renderer renderer;
  if (auto drawn = renderer.render(scene, options, result); !drawn) {
    return tl::unexpected(drawn.error());
  }
  return result;
}

}  // namespace lustro
