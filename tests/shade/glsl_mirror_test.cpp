// lighting.glsl, fog.glsl, vertex.glsl and fragment.glsl, compiled as C++ (glsl_shim.hpp), against lighting.hpp on a million random surfaces.
//
// The tolerance: both sides do the same float operations in the same order, so only powers differ. power() has a relative error below
// 1e-6 (1 + |n log2 x|), libm's pow() of float is right to one ulp. A highlight x^n = 2^-y is then off by at most 1e-6 (1 + y) 2^-y < 1.2e-6 of
// its full strength, the same holds for a spot's cs^e, and 1/d^p with p <= 3 and 1/100 < d < 100 by 1e-6 (1 + 20) of itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "image/srgb.hpp"
#include "shade/fog.hpp"
#include "shade/glsl_programs.hpp"
#include "shade/interpolation.hpp"
#include "shade/lighting.hpp"
#include "shade/random_surface.hpp"

namespace lustro {
namespace {

using namespace glsl_programs;

constexpr float kRelative = 2.5e-5F;
constexpr float kAbsolute = 4e-6F;

Vec3f from_glsl(const glsl::vec3& a) {
  return {a.x.v, a.y.v, a.z.v};
}
glsl::vec3 to_glsl(const Vec3f& a) {
  return {a.x, a.y, a.z};
}

/// Sets the uniforms `material`, `ambient_light`, `lights` and `light_count`.
template <class Program>
void set_scene(Program& program, const Coefficients<float>& k, const Vec3f& ambient_light, const std::vector<ShadingLight>& lights) {
  program.material.ambient = to_glsl(k.ambient);
  program.material.diffuse = to_glsl(k.diffuse);
  program.material.specular = to_glsl(k.specular);
  program.material.emission = to_glsl(k.emission);
  program.material.shininess = k.shininess.n;
  if constexpr (requires { program.light_count; }) {
    program.ambient_light = to_glsl(ambient_light);
    program.light_count = static_cast<int>(lights.size());
    for (std::size_t i = 0; i < lights.size(); ++i) {
      auto& to = program.lights[i];
      const ShadingLight& from = lights[i];
      to.type = static_cast<int>(from.type);
      to.position = to_glsl(from.position);
      to.travel = to_glsl(from.travel);
      to.ambient = to_glsl(from.ambient);
      to.diffuse = to_glsl(from.diffuse);
      to.specular = to_glsl(from.specular);
      to.attenuation = to_glsl(from.attenuation);
      to.falloff = from.falloff;
      to.attenuation_limit = from.attenuation_limit;
      to.range_scale = from.range_scale;
      to.cos_cutoff = from.cos_cutoff;
      to.cos_beam = from.cos_beam;
      to.beam_scale = from.beam_scale;
      to.fades_quadratically = from.fade == SpotFade::quadratic;
      to.exponent = from.exponent.n;
    }
  }
}

struct RandomScene {
  Coefficients<float> k;
  Vec3f ambient_light;
  std::vector<ShadingLight> lights;
};

RandomScene random_scene(RandomSurface& random, std::size_t light_count) {
  RandomScene scene{random.coefficients(), random.color(), {}};
  for (const Light& light : random.lights(light_count)) {
    scene.lights.push_back(textbook::ready(light));
  }
  return scene;
}

Vec3f lit(Lighting model, const Surface<float>& s, const RandomScene& scene, bool normalized = false) {
  return light_surface(model, s, scene.k, scene.ambient_light, scene.lights, normalized,
                       [](std::size_t, const Incident<float>&, const LightTerms<float>&) {})
      .sum();
}

/// The largest difference in units of the tolerance, over everything that was compared.
class Worst {
 public:
  void compare(const Vec3f& mirror, const Vec3f& expected) {
    compare(mirror.x, expected.x);
    compare(mirror.y, expected.y);
    compare(mirror.z, expected.z);
  }
  void compare(float mirror, float expected) {
    const float error = std::abs(mirror - expected) / (kAbsolute + kRelative * std::abs(expected));
    worst_ = std::isnan(worst_) || error <= worst_ ? worst_ : error;  // keeps NaN
    brightest_ = std::max(brightest_, expected);
  }
  void expect_within() const {
    EXPECT_LE(worst_, 1.0F);
    EXPECT_GT(brightest_, 0.5F) << "nothing was lit, nothing was compared";
  }

 private:
  float worst_ = 0, brightest_ = 0;
};

template <class Program>
void compare_fragments(Lighting model, bool normalized, int rounds) {
  RandomSurface random(static_cast<std::uint32_t>(model) + 10);
  Program program;
  Worst worst;
  for (int i = 0; i < rounds; ++i) {
    Surface<float> s = random.surface();
    s.to_eye = normalize(-s.position);
    const RandomScene scene = random_scene(random, 1 + random.below(3));
    set_scene(program, scene.k, scene.ambient_light, scene.lights);
    program.surface_position = to_glsl(s.position);
    program.surface_normal = to_glsl(s.normal);
    s.normal = normalize(s.normal);
    program.main();
    worst.compare(from_glsl(glsl::vec3(program.fragment_color)), lit(model, s, scene, normalized));
  }
  worst.expect_within();
}

TEST(GlslMirror, PhongPerFragment) {
  compare_fragments<PhongFragment>(Lighting::phong, false, 200000);
}
TEST(GlslMirror, BlinnPhongPerFragment) {
  compare_fragments<BlinnPhongFragment>(Lighting::blinn_phong, false, 200000);
}
TEST(GlslMirror, NormalizedPhongPerFragment) {
  compare_fragments<NormalizedPhongFragment>(Lighting::phong, true, 100000);
}
TEST(GlslMirror, NormalizedBlinnPhongPerFragment) {
  compare_fragments<NormalizedBlinnPhongFragment>(Lighting::blinn_phong, true, 100000);
}
TEST(GlslMirror, GgxPerFragment) {
  compare_fragments<GgxFragment>(Lighting::ggx, false, 200000);
}
TEST(GlslMirror, LambertPerFragment) {
  compare_fragments<LambertFragment>(Lighting::lambert, false, 100000);
}
TEST(GlslMirror, ConstantPerFragment) {
  compare_fragments<ConstantFragment>(Lighting::constant, false, 1000);
}

TEST(GlslMirror, OrthographicTwoSidedFoggedAndEncoded) {
  RandomSurface random(5);
  RichFragment program;
  Worst worst;
  for (int i = 0; i < 100000; ++i) {
    Surface<float> s = random.surface();
    s.to_eye = random.direction();
    const RandomScene scene = random_scene(random, 2);
    set_scene(program, scene.k, scene.ambient_light, scene.lights);
    const bool is_front = random.chance(0.5F);
    const ShadingFog fog{.mode = static_cast<FogMode>(random.below(3)),
                         .density = random.between(0, 0.3F),
                         .end = random.between(8, 30),
                         .range_scale = 1 / random.between(1, 20),
                         .color = random.color()};
    program.fog.mode = static_cast<int>(fog.mode);
    program.fog.density = fog.density;
    program.fog.end = fog.end;
    program.fog.range_scale = fog.range_scale;
    program.fog.color = to_glsl(fog.color);
    program.surface_position = to_glsl(s.position);
    program.surface_normal = to_glsl(s.normal);
    program.view_to_eye = to_glsl(s.to_eye);
    program.gl_FrontFacing = is_front;
    program.main();

    s.normal = normalize(s.normal) * (is_front ? 1.0F : -1.0F);
    const float clear = fog_factor(fog, length(s.position));
    const Vec3f color = lit(Lighting::blinn_phong, s, scene) * clear + fog.color * (1.0F - clear);
    const auto encode = [](float x) { return srgb_encode(clamp01(x)); };
    worst.compare(from_glsl(glsl::vec3(program.fragment_color)), {encode(color.x), encode(color.y), encode(color.z)});
    EXPECT_EQ(program.fragment_color.w.v, 1.0F);
  }
  worst.expect_within();
}

TEST(GlslMirror, TheVertexBringsPositionAndNormal) {
  PhongVertex program;
  program.eye_from_object.m[0][3] = 5.0;
  program.clip_from_eye.m[3][2] = -1.0;
  program.clip_from_eye.m[3][3] = 0.0;
  program.normal_from_object.rows[0] = {0.0, 2.0, 0.0};
  program.position = {1.0, 2.0, -3.0};
  program.normal = {0.0, 1.0, 0.0};
  program.main();
  EXPECT_EQ(from_glsl(program.surface_position), (Vec3f{6, 2, -3}));
  EXPECT_EQ(program.gl_Position.w.v, 3.0F);
  EXPECT_NEAR(program.surface_normal.x.v, 2 / std::sqrt(5.0), 1e-6);  // (2, 1, 0), made unit
}

TEST(GlslMirror, GouraudPerVertex) {  // lit and clamped at three vertices, then interpolated
  RandomSurface random(1971);
  GouraudVertex vertex;
  GouraudFragment fragment;
  Worst worst;
  int clamped = 0;
  for (int i = 0; i < 70000; ++i) {
    const RandomScene scene = random_scene(random, 2);
    set_scene(vertex, scene.k, scene.ambient_light, scene.lights);
    const bool is_front = random.chance(0.5F);
    float a = random.unit();
    float b = random.unit();
    const Weights<float> w{1 - std::max(a, b), std::abs(a - b), std::min(a, b)};
    std::array<Vec3f, 3> front, back, expected;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Surface<float> s = random.surface();
      s.to_eye = normalize(-s.position);
      vertex.position = to_glsl(s.position);
      vertex.normal = to_glsl(s.normal);
      vertex.main();
      front[corner] = from_glsl(vertex.front_color);
      back[corner] = from_glsl(vertex.back_color);
      s.normal = normalize(s.normal) * (is_front ? 1.0F : -1.0F);
      const Vec3f color = lit(Lighting::phong, s, scene);
      clamped += std::max({color.x, color.y, color.z}) > 1 ? 1 : 0;
      expected[corner] = {clamp01(color.x), clamp01(color.y), clamp01(color.z)};
    }
    fragment.front_color = to_glsl(weighted_sum(front, w));
    fragment.back_color = to_glsl(weighted_sum(back, w));
    fragment.gl_FrontFacing = is_front;
    fragment.main();
    worst.compare(from_glsl(glsl::vec3(fragment.fragment_color)), weighted_sum(expected, w));
  }
  worst.expect_within();
  EXPECT_GT(clamped, 10000);
}

TEST(GlslMirror, FlatPerFace) {  // lit at the face's centre with the face's normal, wherever the vertex lies; not clamped
  RandomSurface random(3);
  FlatVertex program;
  Worst worst;
  for (int i = 0; i < 50000; ++i) {
    Surface<float> s = random.surface();
    s.to_eye = normalize(-s.position);
    const RandomScene scene = random_scene(random, 2);
    set_scene(program, scene.k, scene.ambient_light, scene.lights);
    program.position = to_glsl(random.direction());
    program.face_center = to_glsl(s.position);
    program.face_normal = to_glsl(s.normal);
    program.main();
    s.normal = normalize(s.normal);
    worst.compare(from_glsl(program.front_color), lit(Lighting::blinn_phong, s, scene));
    s.normal = -s.normal;
    worst.compare(from_glsl(program.back_color), lit(Lighting::blinn_phong, s, scene));
  }
  worst.expect_within();
}

}  // namespace
}  // namespace lustro
