// See textured.hpp. Its sines come from the C library: nothing here has to have the same bits everywhere.
#include "common/textured.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace lustro::bench {
namespace {

constexpr int kSize = 1024;
constexpr double kPi = 3.14159265358979323846;

ByteImage picture(const std::function<Vec3d(double, double)>& color) {
  ByteImage image{kSize, kSize, 3, {}};
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const Vec3d c = color(2 * kPi * x / kSize, 2 * kPi * y / kSize);
      for (const double channel : {c.x, c.y, c.z}) {
        image.pixels.push_back(static_cast<std::uint8_t>(std::lround(255 * std::clamp(channel, 0.0, 1.0))));
      }
    }
  }
  return image;
}

TextureUse use_of(const ByteImage& bytes) {
  Image image(bytes.width, bytes.height, 3);
  std::transform(bytes.pixels.begin(), bytes.pixels.end(), image.pixels.begin(), [](std::uint8_t b) { return static_cast<float>(b) / 255; });
  auto texture = make_texture(image);
  if (!texture) {
    throw std::runtime_error(texture.error().text());
  }
  TextureUse use;
  use.texture = *texture;
  return use;
}

// How often a map is laid along a circle, to and fro.
constexpr double kAlong = 6, kAround = 2;

struct ToAndFro {
  double value, slope;  // slope: -1 or 1
};
ToAndFro to_and_fro(double share) {
  return share < 0.5 ? ToAndFro{2 * share, 1} : ToAndFro{2 - 2 * share, -1};
}

}  // namespace

Maps make_maps() {
  return {picture([](double x, double y) {
            return Vec3d{0.6 + 0.3 * std::sin(5 * x) * std::cos(3 * y), 0.6 + 0.3 * std::sin(7 * y), 0.7 + 0.2 * std::cos(4 * x + 2 * y)};
          }),
          picture([](double x, double y) {
            const double v = 0.5 + 0.4 * std::cos(6 * x) * std::cos(6 * y);
            return Vec3d{v, v, v};
          }),
          picture([](double x, double y) {
            const Vec3d n = normalize(Vec3d{0.3 * std::sin(12 * x), 0.3 * std::sin(10 * y), 1});
            return Vec3d{n.x * 0.5 + 0.5, n.y * 0.5 + 0.5, n.z * 0.5 + 0.5};
          })};
}

Scene textured_scene(const Subject& subject, const Maps& maps) {
  Scene scene = common_scene(subject, 1);
  Object& object = scene.objects.front();
  Mesh mesh = *object.mesh;
  const auto rings = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(subject.triangles))));
  const std::size_t sides = mesh.positions.size() / rings;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const ToAndFro u = to_and_fro(static_cast<double>(i / sides) / static_cast<double>(rings));
    const ToAndFro v = to_and_fro(static_cast<double>(i % sides) / static_cast<double>(sides));
    mesh.uvs.push_back({static_cast<float>(kAlong * u.value), static_cast<float>(kAround * v.value)});
    const Vec3d p = vec_cast<double>(mesh.positions[i]);
    const Vec3d n = vec_cast<double>(mesh.normals[i]);
    const Vec3d along = Vec3d{-p.z, 0, p.x} * u.slope;  // the ring's direction
    const Vec3f tangent = vec_cast<float>(normalize(along - n * dot(along, n)));
    mesh.tangents.push_back({tangent.x, tangent.y, tangent.z, static_cast<float>(u.slope * v.slope)});
  }
  object.mesh = std::make_shared<const Mesh>(std::move(mesh));
  object.material->textures.diffuse = use_of(maps.diffuse);
  object.material->textures.specular = use_of(maps.specular);
  object.material->textures.normal = use_of(maps.normal);
  return scene;
}

}  // namespace lustro::bench
