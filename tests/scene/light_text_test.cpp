// Whole lights, materials and fogs as one text.
#include <gtest/gtest.h>

#include "scene/text_values.hpp"

namespace lustro {
namespace {

TEST(LightText, APointLightIsAPositionAndKeys) {
  const Light light = parse_light("point 2,3,4 color=#fff attenuation=1,0.1,0.02 ambient=0.1,0.1,0.2 name=lamp").value();
  EXPECT_EQ(light.type, LightType::point);
  EXPECT_EQ(light.position, (Vec3d{2, 3, 4}));
  EXPECT_EQ(light.diffuse, (Color{{1, 1, 1}, ColorSpace::encoded}));
  EXPECT_EQ(light.specular, light.diffuse);
  EXPECT_EQ(light.ambient, (Color{{0.1F, 0.1F, 0.2F}, ColorSpace::linear}));
  EXPECT_EQ(light.attenuation.constant, 1);
  EXPECT_EQ(light.attenuation.linear, 0.1);
  EXPECT_EQ(light.attenuation.quadratic, 0.02);
  EXPECT_EQ(light.name, "lamp");
}

TEST(LightText, ADirectionalLightIsADirection) {
  const Light light = parse_light("  directional   -1,-1,0 ").value();
  EXPECT_EQ(light.type, LightType::directional);
  EXPECT_EQ(light.direction, (Vec3d{-1, -1, 0}));
}

TEST(LightText, ASpotLightIsAPositionADirectionAndItsCone) {
  const Light light = parse_light("spot 0,4,0 0,-1,0 cutoff=30 beam=20 exponent=8 falloff=2 unclamped specular=#000").value();
  EXPECT_EQ(light.type, LightType::spot);
  EXPECT_EQ(light.position, (Vec3d{0, 4, 0}));
  EXPECT_EQ(light.direction, (Vec3d{0, -1, 0}));
  EXPECT_EQ(light.cutoff, 30);
  EXPECT_EQ(light.beam, 20);
  EXPECT_EQ(light.exponent, 8);
  EXPECT_EQ(light.attenuation.falloff, 2);
  EXPECT_TRUE(light.attenuation.unclamped);
  EXPECT_EQ(light.specular, (Color{{0, 0, 0}, ColorSpace::encoded}));
  EXPECT_EQ(light.diffuse, Light{}.diffuse);
}

TEST(LightText, SaysWhatIsWrong) {
  EXPECT_EQ(parse_light("").error().message, "found nothing, expected a light: directional, point, spot, rectangle, disk, sphere");
  EXPECT_EQ(parse_light("pont 1,2,3").error().message,
            "unknown word \"pont\", did you mean \"point\"? (known: directional, point, spot, rectangle, disk, sphere)");
  EXPECT_EQ(parse_light("point 1,2").error().message, "position: found \"1,2\", expected three numbers x,y,z");
  EXPECT_EQ(parse_light("point 1,2,3 4,5,6").error().message, "found \"4,5,6\", expected key=value");
  EXPECT_EQ(parse_light("spot 0,0,0 0,0,1 cutoff=120").error().message, "cutoff: 120 is outside 0..90");
  EXPECT_EQ(parse_light("point 0,0,0 colour=red").error().message.substr(0, 46), "unknown key \"colour\", did you mean \"color\"? (k");
  EXPECT_EQ(parse_light("point 0,0,0 color=red").error().message,
            "color: found \"red\", expected a colour: #rgb, #rrggbb or three numbers r,g,b");
  EXPECT_EQ(parse_light("point 0,0,0 attenuation=1,-1,0").error().message, "attenuation: -1 is not 0 or more");
}

TEST(MaterialText, IsALibraryMaterialWithChanges) {
  EXPECT_EQ(parse_material("jade").value(), library_material("jade").value());
  Material changed = library_material("jade").value();
  changed.shininess = 20;
  EXPECT_EQ(parse_material("jade,shininess=20").value(), changed);
  EXPECT_EQ(parse_material("jade shininess=20").value(), changed);
}

TEST(MaterialText, ReadsColoursWithCommas) {
  const Material material = parse_material("diffuse=1,0.5,0,shininess=20,specular=#fff,lighting=lambert").value();
  EXPECT_EQ(material.diffuse, (Color{{1, 0.5F, 0}, ColorSpace::linear}));
  EXPECT_EQ(material.shininess, 20);
  EXPECT_EQ(material.specular, (Color{{1, 1, 1}, ColorSpace::encoded}));
  EXPECT_EQ(material.lighting, Lighting::lambert);
  EXPECT_EQ(material.ambient, Material{}.ambient);
}

TEST(MaterialText, SaysWhatIsWrong) {
  EXPECT_EQ(parse_material("").error().message, "found nothing, expected a library material or key=value");
  EXPECT_EQ(parse_material("jad").error().message.substr(0, 45), "unknown material \"jad\", did you mean \"jade\"? ");
  EXPECT_EQ(parse_material("shininess=-1").error().message, "shininess: -1 is outside 0..10000");
  EXPECT_EQ(parse_material("opacity=1.5").error().message, "opacity: 1.5 is outside 0..1");
  EXPECT_EQ(parse_material("shine=3").error().message.substr(0, 19), "unknown key \"shine\"");
}

TEST(FogText, IsAModeAndKeys) {
  const Fog fog = parse_fog("linear start=2 end=9 color=#808080").value();
  EXPECT_EQ(fog.mode, FogMode::linear);
  EXPECT_EQ(fog.start, 2);
  EXPECT_EQ(fog.end, 9);
  EXPECT_EQ(fog.color, (Color{{128.0F / 255, 128.0F / 255, 128.0F / 255}, ColorSpace::encoded}));
  EXPECT_EQ(parse_fog("density=0.2")->mode, FogMode::exp);
  EXPECT_EQ(parse_fog("exp3").error().message, "mode: unknown word \"exp3\", did you mean \"exp\"? (known: linear, exp, exp2)");
  EXPECT_EQ(parse_fog("exp density=-1").error().message, "density: -1 is not 0 or more");
  EXPECT_FALSE(parse_fog(""));
}

}  // namespace
}  // namespace lustro
