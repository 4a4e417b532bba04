// A picture that several draw together, each its share of the rows; and what a rendering says of the choices it made.
#include <gtest/gtest.h>

#include <algorithm>

#include "lustro/render.hpp"

namespace lustro {
namespace {

Scene scene() {
  Scene scene;
  Object object;
  object.source = "primitive:teapot";
  scene.objects.push_back(object);
  scene.image.width = 150;
  scene.image.height = 301;  // the last row of tiles is cut
  EXPECT_TRUE(load_meshes(scene, {}, {}));
  return scene;
}

TEST(Share, SharesTogetherAreThePicture) {
  const Scene stated = scene();
  const auto whole = render(stated, {.store_bytes = true});
  ASSERT_TRUE(whole);
  ASSERT_EQ(whole->bands, (std::vector<Band>{{0, 301}}));
  for (const int count : {2, 3, 64}) {
    Image together(150, 301, 4);
    std::vector<int> drawn(301, 0);
    std::uint64_t covered = 0;
    for (int index = 0; index < count; ++index) {
      const auto part = render(stated, {.threads = 2, .share = {index, count}});
      ASSERT_TRUE(part) << part.error().text();
      covered += part->stats.pixels_covered;
      for (const Band& band : part->bands) {
        ASSERT_LT(band.begin, band.end);
        for (int y = band.begin; y < band.end; ++y) {
          ++drawn[static_cast<std::size_t>(y)];
          std::copy_n(part->color.at(0, y).data(), 150 * 4, together.at(0, y).data());
        }
      }
    }
    EXPECT_EQ(std::count(drawn.begin(), drawn.end(), 1), 301) << count;
    EXPECT_EQ(covered, whole->stats.pixels_covered);
    EXPECT_EQ(hash_image(together), hash_image(whole->color));
  }
}

TEST(Share, WhatIsNoneIsRefused) {
  for (const Share share : {Share{-1, 2}, Share{2, 2}, Share{0, 0}}) {
    const auto part = render(scene(), {.share = share});
    ASSERT_FALSE(part);
    EXPECT_EQ(part.error().kind, ErrorKind::usage);
  }
}

TEST(Choices, WhatTheSceneLeavesOpenIsReported) {
  Scene stated = scene();
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    stated.camera = {.projection = projection};
    const auto open = render(stated);
    ASSERT_TRUE(open);
    EXPECT_EQ(open->lights.size(), 3U);  // the default rig
    Scene closed = stated;
    closed.camera = open->camera;
    closed.lights = open->lights;
    ASSERT_TRUE(closed.camera.eye && closed.camera.target && closed.camera.up && closed.camera.near && closed.camera.far);
    EXPECT_EQ(closed.camera.height.has_value(), projection == Projection::orthographic);
    const auto again = render(closed);
    ASSERT_TRUE(again);
    const auto difference = compare_images(open->color, again->color);
    ASSERT_TRUE(difference);
    EXPECT_LT(difference->mean, 1e-4);  // directions are made again from places
  }
}

}  // namespace
}  // namespace lustro
