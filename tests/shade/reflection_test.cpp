// Reflection maps: every direction finds its place, by formulas in double precision, and slopes are derivatives.
#include "shade/reflection.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "shade/direction_picture.hpp"
#include "texture/texture.hpp"

namespace lustro {
namespace {

Vec3f unit(double x, double y, double z) {
  return vec_cast<float>(normalize(Vec3d{x, y, z}));
}

Vec3f random_direction(std::mt19937& random) {
  for (;;) {
    const auto number = [&] { return static_cast<double>(random() >> 8) / 8388608.0 - 1; };
    const Vec3d d{number(), number(), number()};
    if (dot(d, d) > 0.01 && dot(d, d) < 1) {
      return vec_cast<float>(normalize(d));
    }
  }
}

struct Place {
  double u, v;
};

Place on_sphere_by_libm(const Vec3d& d) {
  return {0.5 + std::atan2(d.x, -d.z) / (2 * kPi), std::acos(d.y / length(d)) / kPi};
}

// OpenGL 4.6, table 8.19 and equation 8.27.
Place on_face_by_the_table(std::size_t face, const Vec3d& r) {
  double s = 0, t = 0, m = 0;
  switch (face) {
    case 0:
      s = -r.z, t = -r.y, m = r.x;
      break;
    case 1:
      s = r.z, t = -r.y, m = r.x;
      break;
    case 2:
      s = r.x, t = r.z, m = r.y;
      break;
    case 3:
      s = r.x, t = -r.z, m = r.y;
      break;
    case 4:
      s = r.x, t = -r.y, m = r.z;
      break;
    default:
      s = -r.x, t = -r.y, m = r.z;
      break;
  }
  return {0.5 * (s / std::abs(m) + 1), 0.5 * (t / std::abs(m) + 1)};
}

std::size_t face_by_the_table(const Vec3d& r) {
  const double x = std::abs(r.x), y = std::abs(r.y), z = std::abs(r.z);
  if (x >= y && x >= z) {
    return r.x < 0 ? 1 : 0;
  }
  return y >= z ? (r.y < 0 ? 3 : 2) : (r.z < 0 ? 5 : 4);
}

TEST(Reflection, TheSpheresMiddleEdgesAndPolesAreWhereTheyAreSaidToBe) {
  const auto at = [](const Vec3f& d) { return on_sphere<float>({d, {}, {}}); };
  const auto expect = [&](const Vec3f& d, float u, float v) {
    EXPECT_NEAR(at(d).u, u, 1e-6F) << d.x << " " << d.y << " " << d.z;
    EXPECT_NEAR(at(d).v, v, 1e-6F) << d.x << " " << d.y << " " << d.z;
  };
  expect({0, 0, -1}, 0.5F, 0.5F);                              // the middle
  expect({1, 0, 0}, 0.75F, 0.5F);                              // to its right
  expect({-1, 0, 0}, 0.25F, 0.5F);                             // to its left
  EXPECT_NEAR(std::abs(at({0, 0, 1}).u - 0.5F), 0.5F, 1e-6F);  // behind: the edge
  EXPECT_NEAR(at({0, 1, 0}).v, 0, 1e-6F);
  EXPECT_NEAR(at({0, -1, 0}).v, 1, 1e-6F);
  expect(unit(0, 1, -1), 0.5F, 0.25F);
}

TEST(Reflection, EveryDirectionFindsItsPlaceOnTheSphere) {
  std::mt19937 random(3);
  for (int i = 0; i < 20000; ++i) {
    const Vec3f d = random_direction(random);
    const Footprint<float> at = on_sphere<float>({d, {}, {}});
    const Place truth = on_sphere_by_libm(vec_cast<double>(d));
    const double around = std::abs(static_cast<double>(at.u) - truth.u);
    EXPECT_LT(std::min(around, 1 - around), 1e-6 / std::max(0.05, std::hypot(static_cast<double>(d.x), static_cast<double>(d.z))));
    EXPECT_NEAR(static_cast<double>(at.v), truth.v, 1e-6);
  }
}

TEST(Reflection, EveryDirectionFindsItsFaceAndItsPlaceThere) {
  std::mt19937 random(4);
  std::array<int, 6> met{};
  for (int i = 0; i < 20000; ++i) {
    const Vec3f d = random_direction(random);
    const auto face = static_cast<std::size_t>(cube_face(d));
    ASSERT_EQ(face, face_by_the_table(vec_cast<double>(d)));
    const Footprint<float> at = on_cube_face<float>(face, {d, {}, {}});
    const Place truth = on_face_by_the_table(face, vec_cast<double>(d));
    EXPECT_NEAR(static_cast<double>(at.u), truth.u, 3e-7);
    EXPECT_NEAR(static_cast<double>(at.v), truth.v, 3e-7);
    ++met[face];
  }
  for (const int count : met) {
    EXPECT_GT(count, 1000);
  }
}

TEST(Reflection, FacesHaveTheirMiddleOnTheAxisAndMeetAtTheirEdges) {
  const std::array<Vec3f, 6> axes{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
  for (std::size_t face = 0; face < 6; ++face) {
    ASSERT_EQ(cube_face(axes[face]), static_cast<float>(face));
    const Footprint<float> at = on_cube_face<float>(face, {axes[face], {}, {}});
    EXPECT_EQ(at.u, 0.5F);
    EXPECT_EQ(at.v, 0.5F);
  }
  // The edge between +x and +z: the left of +x is the right of +z.
  const Vec3f edge = unit(1, 0.3, 1);
  EXPECT_NEAR(on_cube_face<float>(0, {edge, {}, {}}).u, 0, 1e-6F);
  EXPECT_NEAR(on_cube_face<float>(4, {edge, {}, {}}).u, 1, 1e-6F);
  EXPECT_NEAR(on_cube_face<float>(0, {edge, {}, {}}).v, on_cube_face<float>(4, {edge, {}, {}}).v, 1e-6F);
  // The top of -z is the top of +y turned round: u goes the other way.
  const Vec3f brim = unit(0.4, 1, -1);
  EXPECT_NEAR(on_cube_face<float>(5, {brim, {}, {}}).v, 0, 1e-6F);
  EXPECT_NEAR(on_cube_face<float>(2, {brim, {}, {}}).v, 0, 1e-6F);
  EXPECT_NEAR(on_cube_face<float>(5, {brim, {}, {}}).u + on_cube_face<float>(2, {brim, {}, {}}).u, 1, 1e-6F);
}

// Directions along a curve, in double precision, and the slopes of where they are seen.
TEST(Reflection, SlopesAreDerivatives) {
  std::mt19937 random(5);
  for (int i = 0; i < 2000; ++i) {
    const Vec3d d = vec_cast<double>(random_direction(random));
    const Vec3d side = normalize(cross(d, vec_cast<double>(random_direction(random))));
    const double h = 1e-5;
    const Vec3d before = normalize(d - side * h), after = normalize(d + side * h);
    const DirectionSlopes<float> slopes{vec_cast<float>(d), vec_cast<float>(side), {}};
    const std::size_t face = face_by_the_table(d);
    const Place a = on_face_by_the_table(face, before), b = on_face_by_the_table(face, after);
    const Footprint<float> cube = on_cube_face(face, slopes);
    EXPECT_NEAR(static_cast<double>(cube.u_dx), (b.u - a.u) / (2 * h), 1e-4);
    EXPECT_NEAR(static_cast<double>(cube.v_dx), (b.v - a.v) / (2 * h), 1e-4);
    EXPECT_EQ(cube.u_dy, 0.0F);
    const double flat = std::hypot(d.x, d.z);
    if (flat > 0.05 && std::abs(d.x) > 1e-3) {  // not over the seam
      const Place c = on_sphere_by_libm(before), e = on_sphere_by_libm(after);
      const Footprint<float> sphere = on_sphere(slopes);
      EXPECT_NEAR(static_cast<double>(sphere.u_dx), (e.u - c.u) / (2 * h) * flat, 1e-4);  // as the equator sees it
      EXPECT_NEAR(static_cast<double>(sphere.v_dx), (e.v - c.v) / (2 * h), 1e-4);
    }
  }
}

TEST(Reflection, AtThePolesAFootprintHasTheSizeOfItsAngle) {
  for (const float y : {1.0F, -1.0F}) {
    const Footprint<float> at = on_sphere<float>({{0, y, 0}, {0.01F, 0, 0}, {0, 0, 0.01F}});
    const double turns = 0.01 / (2 * kPi);  // a half turn is the picture's height
    EXPECT_NEAR(std::hypot(static_cast<double>(at.u_dx), 0.5 * static_cast<double>(at.v_dx)), turns, 1e-7);
    EXPECT_NEAR(std::hypot(static_cast<double>(at.u_dy), 0.5 * static_cast<double>(at.v_dy)), turns, 1e-7);
  }
}

TEST(Reflection, TheMirroredViewAndItsSlopesAreThoseOfTheFormula) {
  std::mt19937 random(6);
  for (int i = 0; i < 2000; ++i) {
    const auto moving = [&] {
      const Vec3d at = vec_cast<double>(random_direction(random));
      return std::array<Vec3d, 2>{at, cross(at, vec_cast<double>(random_direction(random)))};
    };
    const auto n = moving(), v = moving();
    const auto mirrored = [&](double t) {
      const Vec3d normal = n[0] + n[1] * t, view = v[0] + v[1] * t;
      return normal * (2 * dot(normal, view)) - view;
    };
    const DirectionSlopes<float> r =
        mirrored_view<float>({vec_cast<float>(n[0]), vec_cast<float>(n[1]), {}}, {vec_cast<float>(v[0]), vec_cast<float>(v[1]), {}});
    const Vec3d error = vec_cast<double>(r.at) - mirrored(0);
    const Vec3d slope_error = vec_cast<double>(r.dx) - (mirrored(1e-5) - mirrored(-1e-5)) * 5e4;
    EXPECT_LT(length(error), 1e-6);
    EXPECT_LT(length(slope_error), 1e-5);
    EXPECT_EQ(length(r.dy), 0);
  }
}

ShadingMap map_of(const Texture& texture) {
  ShadingMap map;
  map.texels = texture.layout();
  map.width = static_cast<float>(texture.width());
  map.height = static_cast<float>(texture.height());
  map.sampler.wrap_v = Wrap::clamp_to_edge;
  return map;
}

TEST(Reflection, TheColourIsThatOfTheDirection) {
  const auto around = picture(256, 128, [](double u, double v) {
    const double longitude = (u - 0.5) * 2 * kPi, colatitude = v * kPi;
    return Vec3d{std::sin(colatitude) * std::sin(longitude), std::cos(colatitude), -std::sin(colatitude) * std::cos(longitude)};
  });
  ShadingReflection sphere;
  sphere.present = 1;
  sphere.faces[0] = map_of(*around);

  ShadingReflection cube;
  cube.shape = ReflectionShape::cube;
  cube.present = 63;
  std::vector<std::shared_ptr<const Texture>> faces;
  for (int face = 0; face < 6; ++face) {
    faces.push_back(picture(64, 64, [face](double u, double v) {
      const double s = 2 * u - 1, t = 2 * v - 1;  // the table, read the other way
      const std::array<Vec3d, 6> seen{{{1, -t, -s}, {-1, -t, s}, {s, 1, t}, {s, -1, -t}, {s, -t, 1}, {-s, -t, -1}}};
      return seen[static_cast<std::size_t>(face)];
    }));
    cube.faces[static_cast<std::size_t>(face)] = map_of(*faces.back());
    cube.faces[static_cast<std::size_t>(face)].sampler.wrap_u = Wrap::clamp_to_edge;
  }
  std::mt19937 random(7);
  for (int i = 0; i < 5000; ++i) {
    const Vec3f d = random_direction(random);
    for (const ShadingReflection* map : {&sphere, &cube}) {
      const Vec3f color = look_up_reflection<TexelReader>(*map, DirectionSlopes<float>{d, {}, {}});
      EXPECT_LT(length(color * 2.0F - Vec3f{1, 1, 1} - d), 0.04F) << d.x << " " << d.y << " " << d.z;  // half a texel at an edge
    }
  }
  cube.present = 63 - 4;
  EXPECT_EQ(look_up_reflection<TexelReader>(cube, DirectionSlopes<float>{{0, 1, 0}, {}, {}}), Vec3f{});
}

}  // namespace
}  // namespace lustro
