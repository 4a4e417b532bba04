// The reference renderer against the equation in double precision, on every pixel of every scene of the tree.
//
// The renderer snaps vertices to 1/256 pixel, each by at most 1/512 in x and in y. What it shows at a pixel's centre is therefore what an exact
// renderer shows at a point of the square of +-1/512 pixel about the centre, and that is what is asked of it:
//   the triangle   is the one that the centre's ray meets, or one that a ray meets which passes at most 1/256 pixel beside it
//   the colour     is the judge's on that triangle at the centre, or lies between those of the square's corners and sides
//   depth, normal and weights (looked at in every fifth pixel) lie between those of the square
// No pixel is left out. How many colours need the square is counted, and must be few.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "lustro/lustro.hpp"
#include "truth/evaluate.hpp"
#include "truth/scene_tree.hpp"
#include "truth/tree_parts.hpp"

namespace lustro::truth {
namespace {

/// The first two steps of a scene's path.
std::string group_of(const TreeScene& entry) {
  return entry.name.substr(0, entry.name.find('/', entry.name.find('/') + 1));
}

std::vector<std::string> groups() {
  std::vector<std::string> names;
  for (const TreeScene& entry : scene_tree()) {
    if (entry.is_judged && std::find(names.begin(), names.end(), group_of(entry)) == names.end()) {
      names.push_back(group_of(entry));
    }
  }
  return names;
}

/// What is compared in a pixel: the stored colour, alpha, depth, the normal that was lit and the triangle's weights.
struct Values {
  static constexpr std::size_t kColors = 4, kDepth = 4, kNormal = 5, kWeights = 8, kCount = 11;
  std::array<double, kCount> v{};

  /// How far apart two values may be. Colours: 1/255.
  static double tolerance(std::size_t i) { return i < kColors ? 1.0 / 255 : i == kDepth ? 2e-6 : 2e-5; }
};

/// In units of the tolerance, how far the first `count` values lie outside lower .. upper.
double excess(const Values& values, const Values& lower, const Values& upper, std::size_t count) {
  double worst = 0;
  for (std::size_t i = 0; i < count; ++i) {
    worst = std::max({worst, (lower.v[i] - values.v[i]) / Values::tolerance(i), (values.v[i] - upper.v[i]) / Values::tolerance(i)});
  }
  return worst;
}

/// The judge's values at an image point, seen on `hit`. Depth in units of `depth_unit`.
Values judged(const Scene& scene, const World& world, double x, double y, const Hit& hit, double depth_unit) {
  const Seen seen = see(scene, world, x, y, hit);
  Values values;
  const std::array<double, 3> color{seen.color.x, seen.color.y, seen.color.z};
  for (std::size_t c = 0; c < 3; ++c) {
    values.v[c] = seen.alpha > 0 ? stored(color[c] / seen.alpha, scene.image.transfer) : 0;
  }
  values.v[3] = seen.alpha;
  if (hit.object >= 0) {
    values.v[Values::kDepth] = hit.depth / depth_unit;
    if (scene.shading.interpolation != Interpolation::gouraud) {
      values.v[Values::kNormal] = seen.normal.x;
      values.v[Values::kNormal + 1] = seen.normal.y;
      values.v[Values::kNormal + 2] = seen.normal.z;
    }
    std::copy(hit.weights.begin(), hit.weights.end(), values.v.begin() + Values::kWeights);
  }
  return values;
}

/// A rendering with the layers that are judged.
struct Judgeable {
  Rendering rendering;
  ByteImage bytes;
  enum : std::size_t { kObject, kTriangle, kNormal, kPosition, kDepth, kBarycentrics, kMask };
  [[nodiscard]] std::span<const float> layer(std::size_t i, int x, int y) const { return rendering.layers[i].image.at(x, y); }
};

Judgeable render_for_judge(const Scene& scene) {
  RenderOptions options;
  options.engine = Engine::reference;
  for (const AovKind kind :
       {AovKind::object, AovKind::triangle, AovKind::normal, AovKind::position, AovKind::depth, AovKind::barycentrics, AovKind::mask}) {
    options.aovs.push_back({kind});
  }
  Result<Rendering> rendering = render(scene, options);
  if (!rendering) {
    throw std::runtime_error(rendering.error().text());
  }
  ByteImage bytes = to_bytes(rendering->color, scene.image.transfer);
  return {std::move(*rendering), std::move(bytes)};
}

/// What the renderer shows in a pixel; `from_bytes`: the colours as its PNG stores them, else as its float picture would.
Values rendered(const Scene& scene, const Judgeable& r, int x, int y, bool from_bytes, double depth_unit) {
  Values values;
  const auto color = r.rendering.color.at(x, y);
  const auto alpha = static_cast<double>(color[3]);
  const std::size_t pixel = static_cast<std::size_t>(y * scene.image.width + x) * 4;
  for (std::size_t c = 0; c < 3; ++c) {
    values.v[c] = from_bytes  ? r.bytes.pixels[pixel + c] / 255.0
                  : alpha > 0 ? stored(static_cast<double>(color[c]) / alpha, scene.image.transfer)
                              : 0;
  }
  values.v[3] = from_bytes ? r.bytes.pixels[pixel + 3] / 255.0 : alpha;
  if (r.layer(Judgeable::kObject, x, y)[0] >= 0) {
    values.v[Values::kDepth] = static_cast<double>(r.layer(Judgeable::kDepth, x, y)[0]) / depth_unit;
    for (std::size_t i = 0; i < 3; ++i) {
      if (scene.shading.interpolation != Interpolation::gouraud) {
        values.v[Values::kNormal + i] = static_cast<double>(r.layer(Judgeable::kNormal, x, y)[i]);
      }
      values.v[Values::kWeights + i] = static_cast<double>(r.layer(Judgeable::kBarycentrics, x, y)[i]);
    }
  }
  return values;
}

/// The judge's triangle for the renderer's: the same one at the centre, else the renderer's if a ray close by meets it. False: neither.
bool explain_choice(const World& world, double x, double y, const Hit& chosen, Hit& hit) {
  constexpr double kSnap = 1.0 / 256;
  for (const double radius : {kSnap / 2, kSnap}) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if ((dx != 0 || dy != 0) && world.cast(x + dx * radius, y + dy * radius).same_place(chosen)) {
          hit = chosen.object < 0 ? Hit{} : world.cast_at(x, y, chosen.object, chosen.triangle);
          return true;
        }
      }
    }
  }
  return false;
}

/// A pixel of several samples is a mixture at edges; it is judged where the rays through its corners meet the same triangle as its centre's.
bool is_inside_one_triangle(const World& world, int x, int y, const Hit& hit) {
  for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
    if (!world.cast(x + dx, y + dy).same_place(hit)) {
      return false;
    }
  }
  return true;
}

/// How well renderings agree with the judge. Differences in units of the tolerances, 1/255 for colours.
struct Agreement {
  int scenes = 0;
  long pixels = 0;       ///< all
  long covered = 0;      ///< in which the judge or the renderer sees a triangle
  long mixed = 0;        ///< of these, mixtures of several triangles in a scene with several samples; not judged
  long moved = 0;        ///< the renderer's triangle is not the centre's, but one of those beside it
  long unexplained = 0;  ///< it is neither
  long beside = 0;       ///< the colour is not the centre's, but one of those beside it
  long rough = 0;        ///< the float picture's colour is more than a tenth of the tolerance off the centre's
  double at_center = 0;  ///< the largest difference from the colour at the centre
  double worst = 0;      ///< the largest difference from the values in the square
  std::string where, first_unexplained;

  /// What is wrong, or nothing.
  [[nodiscard]] std::string objection() const {
    return worst > 1                 ? "a value is off: " + where
           : unexplained > 0         ? "a triangle is in the wrong place: " + first_unexplained
           : covered * 5 <= pixels   ? "the scenes show too little"
           : mixed * 2 > covered     ? "too few pixels can be judged"
           : moved * 500 > covered   ? "too many triangles are beside the centre"
           : beside * 1000 > covered ? "too many colours are beside the centre"
           : rough * 100 > covered   ? "too many colours are more than a tenth of 1/255 off"
                                     : "";
  }

  /// Every pixel of `drawn` against the judge of `entry`, which is the same scene unless the judge itself is on trial.
  void compare(const TreeScene& entry, const Scene& drawn, const World& world, const std::vector<Hit>& hits);

 private:
  void compare_values(const TreeScene& entry, const World& world, const Judgeable& r, int x, int y, const Hit& hit);
};

void Agreement::compare_values(const TreeScene& entry, const World& world, const Judgeable& r, int x, int y, const Hit& hit) {
  const double depth_unit = hit.object < 0 || entry.scene.camera.projection == Projection::perspective
                                ? hit.depth
                                : *entry.scene.camera.far - *entry.scene.camera.near;
  const Values center = judged(entry.scene, world, x + 0.5, y + 0.5, hit, depth_unit);
  Values lower = center;
  Values upper = center;
  const std::array<Values, 2> shown{rendered(entry.scene, r, x, y, false, depth_unit), rendered(entry.scene, r, x, y, true, depth_unit)};
  const auto excess_of_both = [&](std::size_t count) {
    return std::max(excess(shown[0], lower, upper, count), excess(shown[1], lower, upper, count));
  };
  double difference = excess_of_both(Values::kColors);
  at_center = std::max(at_center, difference);
  beside += difference > 1 ? 1 : 0;
  rough += excess(shown[0], lower, upper, Values::kColors) > 0.1 ? 1 : 0;
  const bool wants_all = hit.object >= 0 && (x + 2 * y) % 5 == 0;
  if (difference > 1 || wants_all) {
    for (int dy = -1; dy <= 1 && hit.object >= 0; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const double sx = x + 0.5 + dx / 512.0;
        const double sy = y + 0.5 + dy / 512.0;
        const Values values = judged(entry.scene, world, sx, sy, world.cast_at(sx, sy, hit.object, hit.triangle), depth_unit);
        for (std::size_t i = 0; i < Values::kCount; ++i) {
          lower.v[i] = std::min(lower.v[i], values.v[i]);
          upper.v[i] = std::max(upper.v[i], values.v[i]);
        }
      }
    }
    difference = excess_of_both(wants_all ? Values::kCount : Values::kColors);
  }
  if (difference > worst) {
    worst = difference;
    std::ostringstream text;
    text << entry.name << " (" << x << ", " << y << ") object " << hit.object << " triangle " << hit.triangle << "\n  judge   ";
    std::copy(center.v.begin(), center.v.end(), std::ostream_iterator<double>(text, " "));
    text << "\n  picture ";
    std::copy(shown[0].v.begin(), shown[0].v.end(), std::ostream_iterator<double>(text, " "));
    where = text.str();
  }
}

void Agreement::compare(const TreeScene& entry, const Scene& drawn, const World& world, const std::vector<Hit>& hits) {
  const Scene& scene = entry.scene;
  const Judgeable r = render_for_judge(drawn);
  ++scenes;
  for (int y = 0; y < scene.image.height; ++y) {
    for (int x = 0; x < scene.image.width; ++x) {
      ++pixels;
      Hit hit = hits[static_cast<std::size_t>(y * scene.image.width + x)];
      const Hit chosen{static_cast<int>(r.layer(Judgeable::kObject, x, y)[0]), static_cast<int>(r.layer(Judgeable::kTriangle, x, y)[0]), 0, {}};
      const bool is_background = hit.object < 0 && chosen.object < 0 && r.layer(Judgeable::kMask, x, y)[0] == 0;
      covered += is_background ? 0 : 1;
      if (!is_background && scene.image.samples > 1) {
        if (!is_inside_one_triangle(world, x, y, hit) || !hit.same_place(chosen)) {
          ++mixed;
          continue;
        }
      } else if (!hit.same_place(chosen)) {
        if (!explain_choice(world, x + 0.5, y + 0.5, chosen, hit)) {
          ++unexplained;
          first_unexplained =
              first_unexplained.empty() ? entry.name + " (" + std::to_string(x) + ", " + std::to_string(y) + ")" : first_unexplained;
          continue;
        }
        ++moved;
      }
      compare_values(entry, world, r, x, y, hit);
    }
  }
}

class SceneTree : public testing::TestWithParam<std::string> {};

TEST_P(SceneTree, AgreesWithTheEquationInDoublePrecision) {
  Agreement all;
  std::map<std::string, std::vector<Hit>> known_hits;
  for (const TreeScene* entry : chosen_scenes()) {
    if (entry->is_judged && group_of(*entry) == GetParam()) {
      const World world(entry->scene);
      std::vector<Hit>& hits = known_hits[entry->geometry];
      if (hits.empty()) {
        hits = world.cast_all();
      }
      all.compare(*entry, entry->scene, world, hits);
    }
  }
  if (all.scenes == 0) {
    GTEST_SKIP() << "no scene of this group is among the chosen ones";
  }
  std::printf(
      "%s: %d scenes, %ld of %ld pixels covered; %ld mixed; beside the centre: triangle %ld, colour %ld; over a tenth %ld; worst colour at the "
      "centre %.3f, in "
      "the square, of all values, %.3f\n",
      GetParam().c_str(), all.scenes, all.covered, all.pixels, all.mixed, all.moved, all.beside, all.rough, all.at_center, all.worst);
  EXPECT_EQ(all.objection(), "");
}

/// A judge that never objects is none: each of these small changes of one clause must be noticed.
TEST(SceneTreeJudge, NoticesSmallChanges) {
  using Change = std::pair<const char*, void (*)(Scene&)>;
  const std::vector<Change> changes{
      {"a light's ambient part", [](Scene& s) { (*s.lights)[1].ambient.rgb.x += 0.02F; }},
      {"a light's diffuse part", [](Scene& s) { (*s.lights)[1].diffuse.rgb.y *= 1.02F; }},
      {"a light's specular part", [](Scene& s) { (*s.lights)[0].specular.rgb.z *= 1.1F; }},
      {"the scene's ambient light", [](Scene& s) { s.ambient.rgb.x += 0.04F; }},
      {"emission", [](Scene& s) { s.objects[0].material->emission.rgb.y += 0.01F; }},
      {"shininess", [](Scene& s) { s.objects[0].material->shininess += 1; }},
      {"the limit of the attenuation", [](Scene& s) { (*s.lights)[1].attenuation.unclamped = true; }},
      {"falloff", [](Scene& s) { (*s.lights)[1].attenuation.falloff = 1.95; }},
      {"cutoff", [](Scene& s) { (*s.lights)[2].cutoff += 1; }},
      {"beam", [](Scene& s) { *(*s.lights)[3].beam += 1; }},
      {"the spot's exponent", [](Scene& s) { (*s.lights)[2].exponent += 1; }},
      {"a direction", [](Scene& s) { (*s.lights)[0].direction.x += 0.02; }},
      {"a position", [](Scene& s) { (*s.lights)[1].position.x += 0.02; }},
      {"a term", [](Scene& s) { s.shading.terms.emission = false; }},
      {"the lighting model", [](Scene& s) { s.shading.lighting = Lighting::blinn_phong; }},
      {"the interpolation", [](Scene& s) { s.shading.interpolation = Interpolation::gouraud; }},
      {"normals", [](Scene& s) { s.shading.normals = NormalInterpolation::slerp; }},
      {"normalisation", [](Scene& s) { s.shading.normalized = true; }},
      {"fog",
       [](Scene& s) {
         s.fog = Fog{.mode = FogMode::exp, .density = 0.005, .color = {{1, 1, 1}}};
       }},
      {"the field of view", [](Scene& s) { s.camera.fov += 0.01; }},
      {"the eye", [](Scene& s) { s.camera.eye->x += 0.0005; }},
      {"a matrix", [](Scene& s) { s.objects[0].matrix = s.objects[0].matrix * scaling(1, 1.001, 1); }},
      {"the background", [](Scene& s) { s.image.background.rgb.x += 0.01F; }},
  };
  const auto entry = std::find_if(scene_tree().begin(), scene_tree().end(),
                                  [](const TreeScene& e) { return e.name == "phong/phong/several/falloff_2/perspective"; });
  ASSERT_NE(entry, scene_tree().end());
  TreeScene judged_entry = *entry;
  judged_entry.scene.objects[0].mesh = tree_mesh("primitive:sphere:6");  // coarse: lerp and slerp differ
  const World world(judged_entry.scene);
  const std::vector<Hit> hits = world.cast_all();
  Agreement same;
  same.compare(judged_entry, judged_entry.scene, world, hits);
  EXPECT_EQ(same.objection(), "");
  for (const auto& [name, change] : changes) {
    Scene drawn = judged_entry.scene;
    change(drawn);
    Agreement changed;
    changed.compare(judged_entry, drawn, world, hits);
    EXPECT_NE(changed.objection(), "") << name;
  }
}

/// Nor is one that does not look at maps.
TEST(SceneTreeJudge, NoticesSmallChangesOfMaps) {
  const auto change_diffuse = [](Scene& s, const std::function<void(TextureUse&)>& change) {
    for (Object& object : s.objects) {
      change(*object.material->textures.diffuse);
    }
  };
  using Change = std::pair<const char*, std::function<void(Scene&)>>;
  const std::vector<Change> changes{
      {"no map", [](Scene& s) { s.objects[0].material->textures.emission.reset(); }},
      {"another map's place", [](Scene& s) { std::swap(s.objects[0].material->textures.ambient, s.objects[0].material->textures.specular); }},
      {"an offset", [&](Scene& s) { change_diffuse(s, [](TextureUse& use) { use.uv_matrix[2] += 0.01F; }); }},
      {"a turn", [&](Scene& s) { change_diffuse(s, [](TextureUse& use) { use.uv_matrix[1] += 0.02F; }); }},
      {"a flip", [&](Scene& s) { change_diffuse(s, [](TextureUse& use) { use.uv_matrix[4] = -1; }); }},
      {"wrap", [&](Scene& s) { change_diffuse(s, [](TextureUse& use) { use.sampler.wrap_u = Wrap::clamp_to_edge; }); }},
      {"the magnifying filter", [&](Scene& s) { change_diffuse(s, [](TextureUse& use) { use.sampler.magnify = TextureFilter::nearest; }); }},
      {"mip levels", [&](Scene& s) { change_diffuse(s, [](TextureUse& use) { use.sampler.mip = MipFilter::none; }); }},
      {"a bias", [&](Scene& s) { change_diffuse(s, [](TextureUse& use) { use.sampler.lod_bias = 0.1F; }); }},
      {"no blending along u", [&](Scene& s) { change_diffuse(s, [](TextureUse& use) { use.sampler.blend_u = false; }); }},
      {"gain", [&](Scene& s) { change_diffuse(s, [](TextureUse& use) { use.gain.y = 1.03F; }); }},
      {"base", [&](Scene& s) { change_diffuse(s, [](TextureUse& use) { use.base.z = 0.02F; }); }},
  };
  const auto entry =
      std::find_if(scene_tree().begin(), scene_tree().end(), [](const TreeScene& e) { return e.name == "textures/colors/perspective"; });
  ASSERT_NE(entry, scene_tree().end());
  const World world(entry->scene);
  const std::vector<Hit> hits = world.cast_all();
  Agreement same;
  same.compare(*entry, entry->scene, world, hits);
  EXPECT_EQ(same.objection(), "");
  for (const auto& [name, change] : changes) {
    Scene drawn = entry->scene;
    change(drawn);
    Agreement changed;
    changed.compare(*entry, drawn, world, hits);
    EXPECT_NE(changed.objection(), "") << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, SceneTree, testing::ValuesIn(groups()), [](const auto& param) {
  std::string name = param.param;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
});

}  // namespace
}  // namespace lustro::truth
