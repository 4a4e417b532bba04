// Reading scene files: what each key means and what holds where it is absent. The truth is the scene format's contract.
#include <gtest/gtest.h>

#include "lustro/scene.hpp"
#include "same_scene.hpp"
#include "scene_examples.hpp"

namespace lustro {
namespace {

/// A scene that must parse.
Scene parsed(const std::string& json) {
  auto scene = parse_scene(json, "scene.json");
  if (!scene) {
    ADD_FAILURE() << scene.error().text() << "\nin " << json;
    return {};
  }
  return *std::move(scene);
}

/// A scene with one more key beside `objects`.
Scene parsed_with(const std::string& key) {
  return parsed("{" + key + R"(, "objects": [{"mesh": "primitive:cube"}]})");
}

TEST(SceneFile, ReadsTheExampleOfTheContract) {
  const Scene s = parsed(kExampleScene);
  EXPECT_EQ(s.image.width, 1024);
  EXPECT_EQ(s.image.height, 768);
  EXPECT_EQ(s.image.samples, 4);
  EXPECT_EQ(s.image.transfer, Transfer::srgb);
  EXPECT_EQ(s.image.background, (Color{{0.1F, 0.1F, 0.12F}, ColorSpace::linear}));
  EXPECT_EQ(s.camera.projection, Projection::perspective);
  EXPECT_EQ(s.camera.eye, (Vec3d{1.6, 1.7, 3.4}));
  EXPECT_EQ(s.camera.target, (Vec3d{0, 0, 0}));
  EXPECT_EQ(s.camera.up, (Vec3d{0, 1, 0}));
  EXPECT_EQ(s.camera.fov, 42);
  EXPECT_EQ(s.camera.near, 0.1);
  EXPECT_EQ(s.camera.far, 50);
  EXPECT_EQ(s.shading.crease, 180);
  EXPECT_EQ(s.ambient, (Color{{0.2F, 0.2F, 0.2F}, ColorSpace::linear}));

  ASSERT_TRUE(s.lights);
  ASSERT_EQ(s.lights->size(), 3U);
  const Light& sun = (*s.lights)[0];
  EXPECT_EQ(sun.type, LightType::directional);
  EXPECT_EQ(sun.direction, (Vec3d{-0.4, -0.8, -0.6}));
  EXPECT_EQ(sun.diffuse, (Color{{0.9F, 0.9F, 0.85F}}));
  const Light& lamp = (*s.lights)[1];
  EXPECT_EQ(lamp.type, LightType::point);
  EXPECT_EQ(lamp.position, (Vec3d{2.2, 1.5, 2}));
  EXPECT_EQ(lamp.ambient, (Color{{0.05F, 0.05F, 0.1F}}));
  EXPECT_EQ(lamp.attenuation.constant, 1);
  EXPECT_EQ(lamp.attenuation.linear, 0.05);
  EXPECT_EQ(lamp.attenuation.quadratic, 0.03);
  EXPECT_FALSE(lamp.attenuation.falloff);
  const Light& spot = (*s.lights)[2];
  EXPECT_EQ(spot.type, LightType::spot);
  EXPECT_EQ(spot.cutoff, 28);
  EXPECT_EQ(spot.beam, 20);
  EXPECT_EQ(spot.exponent, 12);
  EXPECT_EQ(spot.attenuation.falloff, 2);
  EXPECT_EQ(spot.diffuse, (Color{{1, 1, 1}}));

  ASSERT_EQ(s.objects.size(), 2U);
  EXPECT_EQ(s.objects[0].source, "bunny.ply");
  ASSERT_TRUE(s.objects[0].material);
  Material jade = library_material("jade").value();
  jade.name = "stone";
  EXPECT_EQ(*s.objects[0].material, jade);
  EXPECT_FALSE(s.objects[1].material);
  EXPECT_EQ(s.objects[1].matrix(0, 3), 0.5);  // row-major: the fourth column moves
  EXPECT_EQ(s.objects[1].matrix(3, 0), 0);
  EXPECT_FALSE(s.objects[0].mesh);
}

TEST(SceneFile, EveryKeyButObjectsIsOptional) {
  const Scene s = parsed(R"({"objects": [{"mesh": "a.ply"}]})");
  EXPECT_EQ(difference(s.image, ImageSettings{}, "image"), "");
  EXPECT_EQ(difference(s.camera, Camera{}, "camera"), "");
  EXPECT_EQ(difference(s.shading, Shading{}, "shading"), "");
  EXPECT_EQ(s.ambient, (Color{{0.2F, 0.2F, 0.2F}}));
  EXPECT_FALSE(s.lights);  // the default rig
  EXPECT_FALSE(s.fog);
  ASSERT_EQ(s.objects.size(), 1U);
  EXPECT_EQ(s.objects[0].matrix, Mat4{});
  EXPECT_FALSE(s.objects[0].material);
}

TEST(SceneFile, DefaultsAreThoseOfTheContract) {
  const Scene s = parsed(R"({"image": {}, "camera": {}, "shading": {}, "fog": {}, "lights": [{}, {"type": "spot"}],
                             "materials": {"m": {}}, "objects": [{"mesh": "a", "material": "m"}]})");
  EXPECT_EQ(s.image.transfer, Transfer::srgb);
  EXPECT_EQ(s.shading.lighting, Lighting::phong);
  EXPECT_EQ(s.shading.interpolation, Interpolation::phong);
  EXPECT_EQ(s.shading.normals, NormalInterpolation::lerp);
  EXPECT_EQ(s.shading.vertex_normals, VertexNormals::angle);
  EXPECT_EQ(s.shading.terms, (TermSet{true, true, true, true}));
  EXPECT_FALSE(s.shading.two_sided);
  EXPECT_FALSE(s.shading.recompute_normals);
  EXPECT_FALSE(s.shading.normalized);
  EXPECT_FALSE(s.shading.crease);  // 180, or 40 for STL
  for (const Light& light : *s.lights) {
    EXPECT_EQ(light.ambient, (Color{{0, 0, 0}}));
    EXPECT_EQ(light.diffuse, (Color{{1, 1, 1}}));
    EXPECT_EQ(light.specular, (Color{{1, 1, 1}}));
    EXPECT_EQ(light.attenuation.constant, 1);
    EXPECT_EQ(light.attenuation.linear, 0);
    EXPECT_EQ(light.attenuation.quadratic, 0);
    EXPECT_FALSE(light.attenuation.unclamped);
    EXPECT_EQ(light.cutoff, 45);
    EXPECT_FALSE(light.beam);
    EXPECT_EQ(light.exponent, 0);
  }
  const Material& m = s.objects[0].material.value();
  EXPECT_EQ(m.ambient, (Color{{0.2F, 0.2F, 0.2F}}));
  EXPECT_EQ(m.diffuse, (Color{{0.8F, 0.8F, 0.8F}}));
  EXPECT_EQ(m.specular, (Color{{0, 0, 0}}));
  EXPECT_EQ(m.emission, (Color{{0, 0, 0}}));
  EXPECT_EQ(m.shininess, 0);
  EXPECT_EQ(m.opacity, 1);
  EXPECT_FALSE(m.lighting);
  EXPECT_EQ(s.fog->mode, FogMode::exp);  // fog's defaults are OpenGL's
  EXPECT_EQ(s.fog->density, 1);
  EXPECT_EQ(s.fog->start, 0);
  EXPECT_EQ(s.fog->end, 1);
  EXPECT_EQ(s.fog->color, (Color{{0, 0, 0}}));
}

TEST(SceneFile, AnEmptyListOfLightsIsNoLight) {
  const Scene s = parsed_with(R"("lights": [])");
  ASSERT_TRUE(s.lights);
  EXPECT_TRUE(s.lights->empty());
}

TEST(SceneFile, ColoursAreListsOrHexText) {
  EXPECT_EQ(parsed_with(R"("ambient": [1, 2.5, 0])").ambient, (Color{{1, 2.5F, 0}, ColorSpace::linear}));
  EXPECT_EQ(parsed_with(R"("ambient": "#ff8000")").ambient, (Color{{1, 128.0F / 255, 0}, ColorSpace::encoded}));
  EXPECT_EQ(parsed_with(R"("ambient": "#f80")").ambient, (Color{{1, 136.0F / 255, 0}, ColorSpace::encoded}));
  EXPECT_EQ(parsed_with(R"x("ambient": "color(srgb 0.1 0.2 0.3)")x").ambient, (Color{{0.1F, 0.2F, 0.3F}, ColorSpace::encoded}));
}

TEST(SceneFile, TheBackgroundMayStateItsAlpha) {
  Scene s = parsed_with(R"("image": {"background": [0.5, 0.5, 0.5, 0.25]})");
  EXPECT_EQ(s.image.background, (Color{{0.5F, 0.5F, 0.5F}}));
  EXPECT_EQ(s.image.background_alpha, 0.25F);
  s = parsed_with(R"("image": {"background": [0, 0, 0]})");
  EXPECT_EQ(s.image.background_alpha, 1);
  s = parsed_with(R"("image": {"background": "#33445580"})");
  EXPECT_EQ(s.image.background_alpha, 128.0F / 255);
  s = parsed_with(R"("image": {"transparent": true})");
  EXPECT_TRUE(s.image.transparent);
}

TEST(SceneFile, TermsKeepOnlyWhatIsNamed) {
  EXPECT_EQ(parsed_with(R"("shading": {"terms": ["specular", "ambient"]})").shading.terms, (TermSet{true, false, true, false}));
  EXPECT_EQ(parsed_with(R"("shading": {"terms": []})").shading.terms, (TermSet{false, false, false, false}));
}

TEST(SceneFile, EveryWordIsRead) {
  EXPECT_EQ(parsed_with(R"("shading": {"lighting": "blinn-phong"})").shading.lighting, Lighting::blinn_phong);
  EXPECT_EQ(parsed_with(R"("shading": {"lighting": "lambert"})").shading.lighting, Lighting::lambert);
  EXPECT_EQ(parsed_with(R"("shading": {"lighting": "constant"})").shading.lighting, Lighting::constant);
  EXPECT_EQ(parsed_with(R"("shading": {"interpolation": "flat"})").shading.interpolation, Interpolation::flat);
  EXPECT_EQ(parsed_with(R"("shading": {"interpolation": "gouraud"})").shading.interpolation, Interpolation::gouraud);
  EXPECT_EQ(parsed_with(R"("shading": {"normals": "slerp"})").shading.normals, NormalInterpolation::slerp);
  EXPECT_EQ(parsed_with(R"("shading": {"vertex_normals": "uniform"})").shading.vertex_normals, VertexNormals::uniform);
  EXPECT_EQ(parsed_with(R"("shading": {"vertex_normals": "area"})").shading.vertex_normals, VertexNormals::area);
  EXPECT_EQ(parsed_with(R"("image": {"transfer": "none"})").image.transfer, Transfer::none);
  EXPECT_EQ(parsed_with(R"("camera": {"projection": "orthographic", "height": 3})").camera.height, 3);
  EXPECT_EQ(parsed_with(R"("camera": {"view": "three-quarter"})").camera.view, ViewPreset::three_quarter);
  EXPECT_EQ(parsed_with(R"("camera": {"view": "bottom"})").camera.view, ViewPreset::bottom);
  EXPECT_EQ(parsed_with(R"("fog": {"mode": "linear", "start": 2, "end": 9})").fog->end, 9);
  EXPECT_EQ(parsed_with(R"("fog": {"mode": "exp2", "density": 0.3, "color": "#fff"})").fog->mode, FogMode::exp2);
}

TEST(SceneFile, KeysBeyondTheContractsExampleAreRead) {
  const Scene s = parsed(R"({"shading": {"two_sided": true, "normalized": true, "recompute_normals": true, "crease": 0},
      "lights": [{"type": "point", "name": "lamp", "attenuation": {"falloff": 0, "unclamped": true}}],
      "objects": [{"mesh": "a", "name": "left", "material": {"lighting": "lambert", "name": "chalk"}}]})");
  EXPECT_TRUE(s.shading.two_sided);
  EXPECT_TRUE(s.shading.normalized);
  EXPECT_TRUE(s.shading.recompute_normals);
  EXPECT_EQ(s.shading.crease, 0);
  EXPECT_EQ((*s.lights)[0].name, "lamp");
  EXPECT_EQ((*s.lights)[0].attenuation.falloff, 0);
  EXPECT_TRUE((*s.lights)[0].attenuation.unclamped);
  EXPECT_EQ(s.objects[0].name, "left");
  EXPECT_EQ(s.objects[0].material->lighting, Lighting::lambert);
  EXPECT_EQ(s.objects[0].material->name, "chalk");
}

TEST(SceneFile, AMaterialIsANameOrATable) {
  const Scene s = parsed(R"({"materials": {"jade": {"shininess": 3}, "gem": "ruby"}, "objects": [
      {"mesh": "a", "material": "jade"}, {"mesh": "a", "material": "gem"}, {"mesh": "a", "material": "gold"}, {"mesh": "a", "material": {"shininess": 7}}]})");
  EXPECT_EQ(s.objects[0].material->shininess, 3);  // the scene's own names come before the library's
  EXPECT_EQ(s.objects[0].material->name, "jade");
  EXPECT_EQ(s.objects[1].material->specular, library_material("ruby")->specular);
  EXPECT_EQ(s.objects[1].material->name, "gem");
  EXPECT_EQ(s.objects[2].material, library_material("gold"));
  EXPECT_EQ(s.objects[3].material->shininess, 7);
  EXPECT_EQ(s.objects[3].material->diffuse, Material{}.diffuse);
  EXPECT_EQ(s.objects[3].material->name, "");
}

TEST(SceneFile, ColoursOfAMaterialTableAreLinearAndOfTheLibraryEncoded) {
  const Scene s = parsed(R"({"objects": [{"mesh": "a", "material": {"diffuse": [0.54, 0.89, 0.63]}}, {"mesh": "a", "material": "jade"}]})");
  EXPECT_EQ(s.objects[0].material->diffuse.space, ColorSpace::linear);
  EXPECT_EQ(s.objects[1].material->diffuse.space, ColorSpace::encoded);
  EXPECT_EQ(s.objects[0].material->diffuse.rgb, s.objects[1].material->diffuse.rgb);
}

TEST(SceneFile, WholeNumbersMayHaveADot) {  // 4.0 is an integer to JSON Schema, too
  EXPECT_EQ(parsed_with(R"("image": {"samples": 4.0, "width": 1e3})").image.width, 1000);
}

TEST(SceneFile, EndsOfRangesAreInsideThem) {
  parsed_with(R"("image": {"width": 1, "height": 16384, "samples": 16})");
  parsed_with(R"("image": {"width": 16384, "height": 1, "samples": 1})");
  parsed_with(R"("camera": {"fov": 179.999999, "near": 1e-30, "far": 3e38})");
  parsed_with(R"("camera": {"fov": 1e-6, "projection": "orthographic", "near": 0})");
  parsed_with(R"("shading": {"crease": 0})");
  parsed_with(R"("shading": {"crease": 180})");
  parsed_with(R"("lights": [{"type": "spot", "cutoff": 90, "beam": 89.99, "exponent": 10000}])");
  parsed_with(R"("lights": [{"type": "spot", "cutoff": 0, "exponent": 0}])");
  parsed_with(R"("lights": [{"type": "spot", "beam": 0}])");
  parsed_with(R"("fog": {"density": 0})");
  parsed_with(R"("ambient": [3.4028234663852886e38, 0, 0])");
  parsed(R"({"objects": [{"mesh": "a", "material": {"shininess": 10000, "opacity": 0}}]})");
  parsed(R"({"objects": [{"mesh": "a", "material": {"shininess": 0, "opacity": 1}}]})");
}

TEST(SceneFile, EditorsMayNameTheSchema) {
  parsed_with(R"("$schema": "scene.schema.json")");
}

TEST(SceneFile, AByteOrderMarkIsNoPartOfIt) {
  parsed("\xef\xbb\xbf{\"objects\": []}");
}

TEST(SceneFile, AnEmptyListOfObjectsIsAScene) {  // render() says that there is nothing to draw
  EXPECT_TRUE(parsed(R"({"objects": []})").objects.empty());
}

}  // namespace
}  // namespace lustro
