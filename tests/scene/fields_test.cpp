// The table of options: that it is whole, and that each entry can do what it says.
#include "scene/fields.hpp"

#include <gtest/gtest.h>

#include <set>

namespace lustro {
namespace {

template <class T>
const Field<T>& field_of(std::string_view key) {
  for (const Field<T>& field : fields<T>()) {
    if (field.key == key) {
      return field;
    }
  }
  throw std::runtime_error(std::string(key));
}

TEST(Fields, HaveUniqueKeysFlagsAndHelp) {
  std::set<std::string> paths;
  std::set<std::string_view> flags;
  for (const FieldGroup& group : field_groups()) {
    EXPECT_FALSE(group.help.empty()) << group.path;
    for (const FieldInfo& field : group.fields) {
      EXPECT_TRUE(paths.insert(std::string(group.path) + "." + std::string(field.key)).second) << group.path << field.key;
      EXPECT_FALSE(field.help.empty()) << field.key;
      EXPECT_NE(field.help.back(), '.') << field.key;
      if (!field.flag.empty()) {
        EXPECT_TRUE(flags.insert(field.flag).second) << field.flag;
        EXPECT_TRUE(field.flag.starts_with("--")) << field.flag;
      }
      EXPECT_EQ(field.words.empty(), field.kind != ValueKind::word && field.kind != ValueKind::terms && field.kind != ValueKind::wrap)
          << field.key;
    }
  }
  EXPECT_EQ(paths.size(), 76U + 3 + 12 + 18 + 8 + 3 + 6 + 3 + 7);
}

/// Every default, written as text and read back, is the default: no range excludes it and no kind loses it.
template <class T>
void expect_defaults_read_back() {
  for (const Field<T>& field : fields<T>()) {
    const ValueKind kind = kind_of(field);
    if (kind == ValueKind::table || kind == ValueKind::objects || kind == ValueKind::materials || kind == ValueKind::lights) {
      continue;
    }
    T object;
    const std::string text = value_text(object, field);
    const auto done = set_from_text(object, field, text);
    EXPECT_TRUE(done) << field.key << ' ' << (done ? "" : done.error().text());
    EXPECT_EQ(value_text(object, field), text) << field.key;
    EXPECT_FALSE(default_text(field).empty() && kind != ValueKind::text) << field.key;
  }
}

TEST(Fields, DefaultsReadBack) {
  expect_defaults_read_back<ImageSettings>();
  expect_defaults_read_back<Camera>();
  expect_defaults_read_back<Shading>();
  expect_defaults_read_back<Light>();
  expect_defaults_read_back<Attenuation>();
  expect_defaults_read_back<Fog>();
  expect_defaults_read_back<Material>();
  expect_defaults_read_back<Object>();
  expect_defaults_read_back<Scene>();
}

TEST(Fields, DefaultsAreThoseOfTheSceneFormat) {
  EXPECT_EQ(default_text(field_of<Shading>("lighting")), "phong");
  EXPECT_EQ(default_text(field_of<Shading>("interpolation")), "phong");
  EXPECT_EQ(default_text(field_of<Shading>("normals")), "lerp");
  EXPECT_EQ(default_text(field_of<Shading>("vertex_normals")), "angle");
  EXPECT_EQ(default_text(field_of<Shading>("terms")), "ambient,diffuse,specular,emission");
  EXPECT_EQ(default_text(field_of<Light>("cutoff")), "45");
  EXPECT_EQ(default_text(field_of<Light>("exponent")), "0");
  EXPECT_EQ(default_text(field_of<Light>("ambient")), "0,0,0");
  EXPECT_EQ(default_text(field_of<Light>("diffuse")), "1,1,1");
  EXPECT_EQ(default_text(field_of<Material>("ambient")), "0.2,0.2,0.2");
  EXPECT_EQ(default_text(field_of<Material>("diffuse")), "0.8,0.8,0.8");
  EXPECT_EQ(default_text(field_of<ImageSettings>("transfer")), "srgb");
  EXPECT_EQ(default_text(field_of<Material>("alpha_mode")), "blend");
  EXPECT_EQ(default_text(field_of<Material>("alpha_cutoff")), "0.5");
  EXPECT_EQ(default_text(field_of<StatedTexture>("mip")), "linear");
  EXPECT_EQ(default_text(field_of<StatedTexture>("scale")), "1,1");
  EXPECT_EQ(default_text(field_of<StatedTexture>("gain")), "1");
  EXPECT_EQ(default_text(field_of<Object>("matrix")), "1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1");
}

TEST(Fields, KindsFollowTheMembers) {
  EXPECT_EQ(kind_of(field_of<ImageSettings>("width")), ValueKind::integer);
  EXPECT_EQ(kind_of(field_of<ImageSettings>("background")), ValueKind::color_alpha);
  EXPECT_EQ(kind_of(field_of<Camera>("eye")), ValueKind::vector);
  EXPECT_TRUE(is_optional(field_of<Camera>("eye")));
  EXPECT_FALSE(is_optional(field_of<Camera>("fov")));
  EXPECT_EQ(kind_of(field_of<Shading>("terms")), ValueKind::terms);
  EXPECT_EQ(kind_of(field_of<Material>("lighting")), ValueKind::word);
  EXPECT_EQ(words_of_field(field_of<Material>("lighting")).size(), 5U);
  EXPECT_EQ(kind_of(field_of<Light>("attenuation")), ValueKind::table);
  EXPECT_EQ(kind_of(field_of<Scene>("materials")), ValueKind::materials);
  EXPECT_EQ(kind_of(field_of<Scene>("lights")), ValueKind::lights);
  EXPECT_EQ(kind_of(field_of<Object>("material")), ValueKind::material);
  EXPECT_EQ(kind_of(field_of<StatedTextures>("bump")), ValueKind::texture);
  EXPECT_EQ(kind_of(field_of<StatedTextures>("reflection")), ValueKind::reflection);
  EXPECT_EQ(kind_of(field_of<StatedTexture>("wrap")), ValueKind::wrap);
  EXPECT_EQ(words_of_field(field_of<StatedTexture>("wrap")).size(), 4U);
  EXPECT_EQ(kind_of(field_of<StatedTexture>("offset")), ValueKind::pair);
  EXPECT_EQ(kind_of(field_of<StatedTexture>("gain")), ValueKind::triple);
  EXPECT_EQ(kind_of(field_of<StatedTexture>("matrix")), ValueKind::affine);
  EXPECT_EQ(kind_of(field_of<StatedTexture>("border")), ValueKind::color_alpha);
}

TEST(Fields, AFailedTextLeavesTheValueAndNamesTheFlag) {
  ImageSettings image;
  const auto done = set_from_text(image, field_of<ImageSettings>("samples"), "3");
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().text(), "--samples: 3 is not 1, 2, 4, 8 or 16");
  EXPECT_EQ(done.error().kind, ErrorKind::usage);
  EXPECT_EQ(image.samples, 4);
  Camera camera;
  EXPECT_EQ(set_from_text(camera, field_of<Camera>("fov"), "180").error().text(), "--fov: 180 is not more than 0 and less than 180");
  EXPECT_EQ(set_from_text(camera, field_of<Camera>("eye"), "1,2,1e39").error().text(),
            "--eye: 1e+39 is too large, the largest number is 3.4028235e+38");
  EXPECT_FALSE(camera.eye);
}

TEST(Fields, OptionalValuesCanBeTakenBack) {
  Camera camera;
  ASSERT_TRUE(set_from_text(camera, field_of<Camera>("eye"), "1,2,3"));
  EXPECT_EQ(camera.eye, (Vec3d{1, 2, 3}));
  ASSERT_TRUE(set_from_text(camera, field_of<Camera>("eye"), "none"));
  EXPECT_FALSE(camera.eye);
}

TEST(Ranges, AreSaidAsTheyAre) {
  EXPECT_EQ(range_text({.lower = 0, .upper = 90}), "0..90");
  EXPECT_EQ(range_text({.lower = 0}), "0 or more");
  EXPECT_EQ(range_text({.lower = 0, .lower_open = true}), "more than 0");
  EXPECT_EQ(range_text({}), "");
  EXPECT_EQ(outside_message({.lower = 0, .upper = 90}, 120), "120 is outside 0..90");
  EXPECT_EQ(outside_message({.lower = 0, .lower_open = true}, 0), "0 is not more than 0");
}

TEST(Ranges, HoldTheirEndsUnlessOpen) {
  constexpr Range kClosed{.lower = 0, .upper = 1};
  constexpr Range kOpen{.lower = 0, .upper = 1, .lower_open = true, .upper_open = true};
  EXPECT_TRUE(kClosed.contains(0) && kClosed.contains(1));
  EXPECT_FALSE(kOpen.contains(0) || kOpen.contains(1));
  EXPECT_TRUE(kOpen.contains(0.5));
  EXPECT_FALSE(Range{}.contains(std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(Range{}.contains(std::numeric_limits<double>::quiet_NaN()));
}

TEST(SceneFlags, ReachEveryPartOfTheScene) {
  Scene scene;
  scene.objects.resize(2);
  const auto set = [&](std::string_view flag, std::string_view text) {
    const auto done = set_scene_flag(scene, flag, text);
    EXPECT_TRUE(done) << flag << ' ' << (done ? "" : done.error().text());
  };
  set("--samples", "16");
  set("--fov", "30");
  set("--lighting", "blinn-phong");
  set("--two-sided", "");
  set("--terms", "diffuse");
  set("--ambient", "0,0,0");
  set("--light", "point 1,2,3");
  set("--light", "directional 0,-1,0");
  set("--fog", "exp2 density=0.5");
  set("--shadow-softness", "3");
  set("--tone", "agx");
  set("--exposure", "-1.5");
  set("--material", "jade");
  EXPECT_EQ(scene.image.samples, 16);
  EXPECT_EQ(scene.camera.fov, 30);
  EXPECT_EQ(scene.shading.lighting, Lighting::blinn_phong);
  EXPECT_TRUE(scene.shading.two_sided);
  EXPECT_EQ(scene.shading.terms, (TermSet{false, true, false, false}));
  EXPECT_EQ(scene.ambient, (Color{{0, 0, 0}}));
  ASSERT_TRUE(scene.lights);
  ASSERT_EQ(scene.lights->size(), 2U);
  EXPECT_EQ(scene.fog->density, 0.5);
  ASSERT_TRUE(scene.shadow);
  EXPECT_EQ(scene.shadow->softness, 3);
  EXPECT_EQ(scene.shadow->size, ShadowSettings{}.size);
  set("--shadows", "true");
  EXPECT_EQ(scene.shadow->softness, 3) << "switching on what is on changes nothing";
  set("--shadows", "false");
  EXPECT_FALSE(scene.shadow);
  EXPECT_EQ(scene.image.tone, (Tone{ToneOperator::agx, -1.5F}));
  for (const Object& object : scene.objects) {
    EXPECT_EQ(object.material, library_material("jade"));
  }
  set("--light", "none");
  ASSERT_TRUE(scene.lights);
  EXPECT_TRUE(scene.lights->empty());
  set("--material", "none");
  EXPECT_FALSE(scene.objects[1].material);
  EXPECT_EQ(set_scene_flag(scene, "--sampels", "1").error().text(), "--sampels: unknown flag");
  EXPECT_EQ(set_scene_flag(scene, "", "1").error().message, "unknown flag");
  EXPECT_EQ(set_scene_flag(scene, "--material", "jad").error().where, "--material");
}

}  // namespace
}  // namespace lustro
