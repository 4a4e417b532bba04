// The sheet of materials: see material_sheet.hpp.
#include "material_sheet.hpp"

#include <map>

#include "image/srgb.hpp"
#include "image/text.hpp"
#include "lustro/render.hpp"
#include "scene/material_groups.hpp"

namespace lustro::app {
namespace {

constexpr int kColumns = 6;
constexpr int kCellWidth = 190, kCellHeight = 204;  // pixels
constexpr int kRadius = 78;                         // of a sphere
constexpr int kLabelBelow = 102;                    // a label's baseline below its sphere's centre
constexpr int kLabelSize = 16, kGroupSize = 20;
constexpr int kLeft = 116, kTop = 14, kRight = 14, kBottom = 10;  // margins; the left one holds the groups' names

struct Cell {
  const Material* material = nullptr;
  int column = 0, row = 0;

  [[nodiscard]] int center_x() const { return kLeft + column * kCellWidth + kCellWidth / 2; }
  [[nodiscard]] int center_y() const { return kTop + row * kCellHeight + kCellHeight / 2 - 12; }
};

struct Layout {
  std::vector<Cell> cells;
  std::map<int, std::string> groups;  ///< the group that begins in a row
  int rows = 0;
};

/// Group by group, each in rows of its own.
Layout lay_out() {
  Layout layout;
  for (const MaterialGroup group : {MaterialGroup::gem, MaterialGroup::metal, MaterialGroup::plastic, MaterialGroup::rubber}) {
    layout.groups[layout.rows] = material_group_name(group);
    int column = 0;
    for (const Material& material : material_library()) {
      if (material_group(material.name) != group) {
        continue;
      }
      if (column == kColumns) {
        column = 0;
        ++layout.rows;
      }
      layout.cells.push_back({&material, column++, layout.rows});
    }
    ++layout.rows;
  }
  return layout;
}

Light directional(const Vec3d& direction, float diffuse, float specular) {
  Light light;
  light.direction = direction;
  light.diffuse = {{diffuse, diffuse, diffuse}, ColorSpace::linear};
  light.specular = {{specular, specular, specular}, ColorSpace::linear};
  return light;
}

/// One unit is one pixel, the origin the picture's centre, so that the layout is also the scene.
Result<Scene> sheet_scene(const Layout& layout) {
  const Result<SourceMesh> source = make_primitive("sphere:96");
  if (!source) {
    return tl::unexpected(source.error());
  }
  Result<BuiltMesh> built = build_mesh(*source);
  if (!built) {
    return tl::unexpected(built.error());
  }
  const auto sphere = std::make_shared<const Mesh>(std::move(built->mesh));

  Scene scene;
  scene.image.width = kLeft + kColumns * kCellWidth + kRight;
  scene.image.height = kTop + layout.rows * kCellHeight + kBottom;
  scene.image.samples = 16;
  scene.image.background = {{0.93F, 0.925F, 0.91F}, ColorSpace::encoded};
  scene.camera.projection = Projection::orthographic;
  scene.camera.eye = Vec3d{0, 0, 1000};
  scene.camera.target = Vec3d{0, 0, 0};
  scene.camera.height = scene.image.height;
  scene.camera.near = 1;
  scene.camera.far = 2000;
  scene.ambient = {{0.35F, 0.35F, 0.35F}};
  scene.lights = std::vector<Light>{directional({0.55, -0.75, -0.8}, 1, 1), directional({-0.7, 0.7, -0.35}, 0.18F, 0)};
  for (const Cell& cell : layout.cells) {
    Object object;
    object.name = cell.material->name;
    object.mesh = sphere;
    object.material = *cell.material;
    for (int i = 0; i < 3; ++i) {
      object.matrix(i, i) = kRadius;
    }
    object.matrix(0, 3) = cell.center_x() - scene.image.width / 2.0;
    object.matrix(1, 3) = scene.image.height / 2.0 - cell.center_y();
    scene.objects.push_back(std::move(object));
  }
  return scene;
}

Vec3f gray(float encoded) {
  const float value = srgb_decode(encoded);
  return {value, value, value};
}

Result<void> draw_labels(Image& image, const Layout& layout) {
  for (const auto& [row, name] : layout.groups) {
    const Cell first{nullptr, 0, row};
    if (const Result<void> drawn = draw_text(image, name, 20, first.center_y() + kGroupSize / 3, kGroupSize, gray(0.45F)); !drawn) {
      return drawn;
    }
  }
  for (const Cell& cell : layout.cells) {
    const Result<TextExtent> extent = measure_text(cell.material->name, kLabelSize);
    if (!extent) {
      return tl::unexpected(extent.error());
    }
    const int x = cell.center_x() - extent->width / 2;
    if (const Result<void> drawn = draw_text(image, cell.material->name, x, cell.center_y() + kLabelBelow, kLabelSize, gray(0.15F)); !drawn) {
      return drawn;
    }
  }
  return {};
}

}  // namespace

Result<Image> material_sheet(int threads, std::function<void(double)> progress) {
  const Layout layout = lay_out();
  const Result<Scene> scene = sheet_scene(layout);
  if (!scene) {
    return tl::unexpected(scene.error());
  }
  Result<Rendering> rendering = render(*scene, {.threads = threads, .aovs = {}, .progress = std::move(progress)});
  if (!rendering) {
    return tl::unexpected(rendering.error());
  }
  if (const Result<void> labelled = draw_labels(rendering->color, layout); !labelled) {
    return tl::unexpected(labelled.error());
  }
  return std::move(rendering->color);
}

}  // namespace lustro::app
