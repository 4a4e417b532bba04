// The rule from metal and roughness to classic coefficients, by values on paper.
#include "io/gltf_material.hpp"

#include "gltf_testing.hpp"

namespace lustro {
namespace {

TEST(GltfMaterial, RoughnessBecomesAnExponent) {
  EXPECT_EQ(shininess_of_roughness(1), 0);              // alpha 1: 2 / 1 - 2
  EXPECT_NEAR(shininess_of_roughness(0.5), 30, 1e-12);  // alpha 1/4: 2 * 16 - 2
  EXPECT_EQ(shininess_of_roughness(0), 10000);          // clamped
  EXPECT_LT(shininess_of_roughness(0.13), 10000);
  EXPECT_EQ(shininess_of_roughness(0.1), 10000);  // 19998
}

TEST(GltfMaterial, MetalSharesItsColourBetweenDiffuseAndSpecular) {
  GltfMaterial m;
  m.base = {1, 0.5, 0, 1};
  m.metallic = 0.25;
  m.roughness = 0.5;
  const Material classic = classic_material(m);
  EXPECT_EQ(classic.diffuse.rgb, (Vec3f{0.75F, 0.375F, 0}));
  EXPECT_NEAR(classic.specular.rgb.x, 0.04 * 0.75 + 0.25, 1e-7);
  EXPECT_NEAR(classic.specular.rgb.y, 0.04 * 0.75 + 0.125, 1e-7);
  EXPECT_NEAR(classic.specular.rgb.z, 0.04 * 0.75, 1e-7);
  EXPECT_EQ(classic.ambient.rgb, (Vec3f{1, 0.5F, 0}));
  EXPECT_EQ(classic.diffuse.space, ColorSpace::linear);
  EXPECT_EQ(classic.lighting, Lighting::blinn_phong);
  EXPECT_NEAR(classic.shininess, 30, 1e-5);
}

TEST(GltfMaterial, SpecularAndIorChangeTheFourPercent) {
  GltfMaterial m;
  m.metallic = 0;
  m.specular = 0.5;
  m.specular_color = {1, 2, 100};
  const Material classic = classic_material(m);
  EXPECT_NEAR(classic.specular.rgb.x, 0.02, 1e-7);
  EXPECT_NEAR(classic.specular.rgb.y, 0.04, 1e-7);
  EXPECT_NEAR(classic.specular.rgb.z, 0.5, 1e-7);  // the colour is limited before the strength
  m = {};
  m.metallic = 0;
  m.ior = 3;
  EXPECT_NEAR(classic_material(m).specular.rgb.x, 0.25, 1e-7);
}

TEST(GltfMaterial, SpecularGlossinessKeepsItsEnergy) {
  GltfMaterial m;
  m.is_specular_glossiness = true;
  m.base = {1, 1, 0.5, 1};
  m.glossy_specular = {0.25, 0.5, 0};
  m.glossiness = 0.5;
  const Material classic = classic_material(m);
  EXPECT_EQ(classic.diffuse.rgb, (Vec3f{0.5F, 0.5F, 0.25F}));
  EXPECT_EQ(classic.specular.rgb, (Vec3f{0.25F, 0.5F, 0}));
  EXPECT_NEAR(classic.shininess, 30, 1e-5);
}

TEST(GltfMaterial, UnlitEmissionAndOpacity) {
  GltfMaterial m;
  m.base = {0.5, 0.5, 0.5, 0.25};
  m.is_unlit = true;
  EXPECT_EQ(classic_material(m).lighting, Lighting::constant);
  EXPECT_EQ(classic_material(m).diffuse.rgb, (Vec3f{0.5F, 0.5F, 0.5F}));
  m.emissive = {0.5, 0, 1};
  m.emissive_strength = 4;
  EXPECT_EQ(classic_material(m).emission.rgb, (Vec3f{2, 0, 4}));
  EXPECT_EQ(classic_material(m).opacity, 1);  // opaque ignores alpha
  EXPECT_EQ(classic_material(m).alpha_mode, AlphaMode::opaque);
  m.alpha = GltfMaterial::Alpha::blend;
  EXPECT_EQ(classic_material(m).opacity, 0.25F);
  m.alpha = GltfMaterial::Alpha::mask;
  EXPECT_EQ(classic_material(m).opacity, 0.25F);
  EXPECT_EQ(classic_material(m).alpha_mode, AlphaMode::mask);
  EXPECT_EQ(classic_material(m).alpha_cutoff, 0.5F);
}

TEST(GltfMaterial, VertexColoursAreOfNoMetal) {
  GltfMaker maker;
  nlohmann::json primitive = maker.triangle();
  maker.add_node_with(primitive);
  primitive["attributes"]["COLOR_0"] = maker.add_accessor<float>("VEC3", {1, 0, 0, 1, 0, 0, 1, 0, 0});
  maker.add_node_with(primitive);
  const SourceMesh mesh = good(maker.mesh());
  ASSERT_EQ(mesh.materials.size(), 2U);
  EXPECT_EQ(mesh.materials[0].diffuse.rgb, (Vec3f{0, 0, 0}));  // the specification's default: a rough metal
  EXPECT_EQ(mesh.materials[1].diffuse.rgb, (Vec3f{1, 1, 1}));
}

}  // namespace
}  // namespace lustro
