#include "io/map_texture.hpp"

#include <algorithm>

#include "io/io_testing.hpp"
#include "io/mtl.hpp"

namespace lustro {
namespace {

using testing::ElementsAre;
using testing::FloatEq;
using testing::IsEmpty;

struct Read {
  std::optional<MapUse> map;
  std::vector<std::string> notes;
  [[nodiscard]] const TextureUse& use() const { return map->use; }
};

/// One map statement as an MTL file has it.
Read read(const std::string& line, const MapSurroundings& around = {}) {
  Read read;
  const MtlFile file = good(parse_mtl("newmtl a\n" + line + "\n", "m.mtl"));
  read.map = use_of_map(file.materials.at(0).maps.at(0), around, [&](const std::string& note) { read.notes.push_back(note); });
  return read;
}

/// uv' of a surface's (u, v).
std::array<float, 2> placed(const TextureUse& use, float u, float v) {
  const auto& m = use.uv_matrix;
  return {m[0] * u + m[1] * v + m[2], m[3] * u + m[4] * v + m[5]};
}

TEST(MapTexture, StatementsHaveTheirPlacesInAnySpelling) {
  const std::vector<std::pair<const char*, const char*>> expected{
      {"map_Ka", "ambient"},    {"map_Kd", "diffuse"},        {"MAP_KD", "diffuse"},  {"map_Ks", "specular"},     {"map_Ke", "emission"},
      {"map_Ns", "shininess"},  {"map_d", "opacity"},         {"map_Tr", "opacity"},  {"map_opacity", "opacity"}, {"decal", "decal"},
      {"bump", "bump"},         {"map_bump", "bump"},         {"map_Bump", "bump"},   {"norm", "normal"},         {"map_Kn", "normal"},
      {"disp", "displacement"}, {"map_Disp", "displacement"}, {"refl", "reflection"}, {"map_refl", "reflection"}};
  for (const auto& [statement, slot] : expected) {
    const Read found = read(std::string(statement) + " a.png");
    ASSERT_TRUE(found.map) << statement;
    EXPECT_EQ(found.map->slot->key, slot) << statement;
    EXPECT_EQ(found.use().name, "a.png");
    EXPECT_THAT(found.notes, IsEmpty());
  }
}

TEST(MapTexture, WhatHasNoPlaceIsNoted) {
  EXPECT_FALSE(read("map_Pr a.png").map);
  EXPECT_THAT(read("map_Pr a.png").notes, ElementsAre("map_Pr is kept, but not drawn: the classic model has no place for it"));
}

TEST(MapTexture, VIsTurnedToGoDownAfterScaleAndOffset) {
  EXPECT_THAT(placed(read("map_Kd a.png").use(), 0.25F, 0), ElementsAre(0.25F, 1));  // OBJ's lower left is the picture's last row
  EXPECT_THAT(placed(read("map_Kd a.png").use(), 0.25F, 1), ElementsAre(0.25F, 0));
  const TextureUse use = read("map_Kd -s 2 4 -o 0.5 0.25 a.png").use();  // (0.125, 0.125): (0.25 + 0.5, 0.5 + 0.25), and 0.75 from below
  EXPECT_THAT(placed(use, 0.125F, 0.125F), ElementsAre(FloatEq(0.75F), FloatEq(0.25F)));
}

TEST(MapTexture, ValuesAreScaledAndRaisedAndBumpsMultiplied) {
  EXPECT_EQ(read("map_Kd -mm 0.5 2 a.png").use().gain, (Vec3f{2, 2, 2}));
  EXPECT_EQ(read("map_Kd -mm 0.5 2 a.png").use().base, (Vec3f{0.5F, 0.5F, 0.5F}));
  EXPECT_EQ(read("bump -bm 3 -mm 0.5 2 a.png").use().gain.x, 6);
  EXPECT_EQ(read("bump -bm 3 -mm 0.5 2 a.png").use().base.x, 1.5F);
}

TEST(MapTexture, TheMultiplierTiltsNormals) {
  const TextureUse use = read("norm -bm 0.5 a.png").use();
  const auto decoded = [&](float texel, float Vec3f::*axis) { return (texel * use.gain.*axis + use.base.*axis) * 2 - 1; };
  EXPECT_EQ(decoded(1, &Vec3f::x), 0.5F);  // 1 before
  EXPECT_EQ(decoded(0.25F, &Vec3f::y), -0.25F);
  EXPECT_EQ(decoded(0.5F, &Vec3f::x), 0);
  EXPECT_EQ(decoded(1, &Vec3f::z), 1);
}

TEST(MapTexture, ClampingLeavesTheMaterialOutside) {
  const TextureUse use = read("map_Kd -clamp on a.png").use();
  EXPECT_TRUE(use.leaves_outside);
  EXPECT_EQ(use.sampler.wrap_u, Wrap::clamp_to_edge);
  EXPECT_EQ(use.sampler.wrap_v, Wrap::clamp_to_edge);
  EXPECT_FALSE(read("map_Kd a.png").use().leaves_outside);
  EXPECT_EQ(read("map_Kd a.png").use().sampler, Sampler());
}

TEST(MapTexture, ReflectionsAreASphereOrTheSixOfACube) {
  const Read sphere = read("refl -type sphere -mm 0 2 a.png");
  ASSERT_TRUE(sphere.map);
  EXPECT_EQ(sphere.map->shape, ReflectionShape::sphere);
  EXPECT_EQ(sphere.map->face, 0U);
  EXPECT_EQ(sphere.use().gain, (Vec3f{2, 2, 2}));
  EXPECT_EQ(read("refl a.png").map->shape, ReflectionShape::sphere);
  EXPECT_THAT(placed(read("refl a.png").use(), 0.25F, 0.125F), ElementsAre(0.25F, 0.125F));  // upright as it is
  // v = 0.75 from above is 0.25 from below, then 0.25 * 2 + 0.25 = 0.75, and from above 0.25
  EXPECT_THAT(placed(read("refl -s 1 2 -o 0 0.25 a.png").use(), 0.25F, 0.75F), ElementsAre(0.25F, 0.25F));
  const std::vector<std::string> faces{"cube_right", "cube_left", "cube_top", "cube_bottom", "cube_front", "cube_back"};
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Read face = read("refl -type " + faces[i] + " a.png");
    ASSERT_TRUE(face.map);
    EXPECT_EQ(face.map->shape, ReflectionShape::cube);
    EXPECT_EQ(face.map->face, i) << faces[i];
    EXPECT_THAT(face.notes, IsEmpty());
  }
  EXPECT_THAT(read("map_Kd -type sphere a.png").notes, ElementsAre("map_Kd: -type is ignored: it belongs to refl"));
}

TEST(MapTexture, ReflectionsNeedAnIlluminationModelThatHasThem) {
  for (const int model : {0, 1, 2}) {
    const Read found = read("refl a.png", {.illumination = model});
    EXPECT_FALSE(found.map);
    EXPECT_THAT(found.notes,
                ElementsAre("refl is kept, but not drawn: it belongs to illum 3 and above, and the material states " + std::to_string(model)));
  }
  for (const int model : {3, 8, 9}) {
    EXPECT_TRUE(read("refl a.png", {.illumination = model}).map);
    EXPECT_TRUE(read("map_Kd a.png", {.illumination = model - 3}).map);
  }
  EXPECT_TRUE(read("refl a.png").map);
}

TEST(MapTexture, HeightsOfDisplacementAreScaledAndRaised) {
  const Read found = read("disp -mm -0.5 2 -imfchan g a.png");
  EXPECT_EQ(found.use().gain.x, 2);
  EXPECT_EQ(found.use().base.x, -0.5F);
  EXPECT_EQ(found.use().channel, 1);
  EXPECT_FALSE(found.map->may_be_normals);
}

TEST(MapTexture, BoostMakesMipLevelsFiner) {
  EXPECT_EQ(read("map_Kd -boost 1.5 a.png").use().sampler.lod_bias, -1.5F);
  EXPECT_EQ(read("map_Kd -boost 1e9 a.png").use().sampler.lod_bias, -16);
  EXPECT_EQ(read("map_Kd -boost 0 a.png").use().sampler, Sampler());
  EXPECT_THAT(read("map_Kd -boost 1.5 a.png").notes, IsEmpty());
  const Read negative = read("map_Kd -boost -1 a.png");
  EXPECT_EQ(negative.use().sampler.lod_bias, 0);
  EXPECT_THAT(negative.notes, ElementsAre("map_Kd: -boost is ignored: below 0 it would blur"));
}

TEST(MapTexture, ColoursAreCorrectedWhereTheyAreDecoded) {
  EXPECT_THAT(read("map_Kd -cc on a.png").notes, IsEmpty());
  EXPECT_THAT(read("map_Kd -cc on a.png", {.transfer = Transfer::none}).notes,
              ElementsAre("map_Kd: -cc is ignored: the scene's transfer takes colours as they stand"));
}

TEST(MapTexture, BlendingIsAChoiceOfEachAxis) {
  const Read none = read("map_Kd -blendu off -blendv off a.png");
  EXPECT_EQ(none.use().sampler.magnify, TextureFilter::nearest);
  EXPECT_EQ(none.use().sampler.minify, TextureFilter::nearest);
  EXPECT_EQ(none.use().sampler.mip, MipFilter::none);
  EXPECT_THAT(none.notes, IsEmpty());
  const Read half = read("map_Kd -blendv off a.png");
  EXPECT_EQ(half.use().sampler, (Sampler{.blend_v = false}));
  EXPECT_EQ(read("map_Kd -blendu off a.png").use().sampler, (Sampler{.blend_u = false}));
  EXPECT_THAT(half.notes, IsEmpty());
}

TEST(MapTexture, ChannelsBelongToMapsOfOneValue) {
  EXPECT_EQ(read("map_d -imfchan g a.png").use().channel, 1);
  EXPECT_TRUE(read("map_d -imfchan g a.png").map->states_channel);
  EXPECT_FALSE(read("map_d a.png").map->states_channel);
  EXPECT_EQ(read("bump -imfchan m a.png").use().channel, 3);
  EXPECT_FALSE(read("bump -imfchan m a.png").map->may_be_normals);
  EXPECT_TRUE(read("bump a.png").map->may_be_normals);
  EXPECT_EQ(read("decal -imfchan r a.png").map->alpha_of_decal, 'r');
  EXPECT_EQ(read("decal a.png").map->alpha_of_decal, 0);
  EXPECT_THAT(read("map_Ns -imfchan z a.png").notes,
              ElementsAre("map_Ns: -imfchan z is ignored: pictures have no depth, the luminance is used"));
  EXPECT_THAT(read("map_Kd -imfchan r a.png").notes, ElementsAre("map_Kd: -imfchan is ignored: it belongs to maps of one value"));
}

TEST(MapTexture, TrIsTheOppositeOfOpacityUnlessTheCallerSaysOtherwise) {
  const auto value = [](const TextureUse& use, float texel) { return texel * use.gain.x + use.base.x; };
  EXPECT_EQ(value(read("map_Tr a.png").use(), 0.25F), 0.75F);
  EXPECT_EQ(value(read("map_Tr -mm 0.5 0.5 a.png").use(), 0.5F), 0.25F);  // 1 - (0.5 + 0.25)
  EXPECT_EQ(value(read("map_Tr a.png", {.transparency_is_tr = true}).use(), 0.25F), 0.25F);
}

TEST(MapTexture, OptionsWithoutEffectAreNoted) {
  EXPECT_THAT(read("map_Kd -t 1 -texres 64 a.png").notes,
              ElementsAre("map_Kd: -t is ignored: the format does not say which noise it means",
                          "map_Kd: -texres is ignored: pictures are used at their own size, which is as sharp as they are"));
  EXPECT_THAT(read("map_Kd -t 0 0 0 -boost 0 -texres 0 -cc off a.png").notes, IsEmpty());  // what exporters write who write all of them
}

const TextureSlot& slot(std::string_view key) {
  return *std::ranges::find(kTextureSlots, key, &TextureSlot::key);
}

TEST(StatedTextures, CoordinatesAreScaledTurnedAndMovedInThisOrder) {
  StatedTexture stated{.file = "a.png"};
  stated.scale = {2, 4};
  stated.rotation = 90;
  stated.offset = {0.5F, 0.25F};
  stated.v_down = true;
  // (0.25, 0.125) becomes (0.5, 0.5), then (-0.5, 0.5), then (0, 0.75)
  EXPECT_THAT(placed(use_of_stated(stated, slot("diffuse"), Transfer::srgb).use, 0.25F, 0.125F), ElementsAre(0, 0.75F));
  stated.v_down = false;
  EXPECT_THAT(placed(use_of_stated(stated, slot("diffuse"), Transfer::srgb).use, 0.25F, 0.125F), ElementsAre(0, 0.25F));
  EXPECT_THAT(placed(use_of_stated({.file = "a.png"}, slot("diffuse"), Transfer::srgb).use, 0.25F, 0.75F), ElementsAre(0.25F, 0.25F));
}

TEST(StatedTextures, AMatrixStandsForThePlacement) {
  StatedTexture stated{.file = "a.png"};
  stated.matrix = {2, 0.5F, 0.25F, -1, 4, 0.5F};
  stated.v_down = true;
  // (0.5, 0.25) becomes (1 + 0.125 + 0.25, -0.5 + 1 + 0.5)
  EXPECT_THAT(placed(use_of_stated(stated, slot("diffuse"), Transfer::srgb).use, 0.5F, 0.25F), ElementsAre(1.375F, 1));
  stated.v_down = false;
  EXPECT_THAT(placed(use_of_stated(stated, slot("diffuse"), Transfer::srgb).use, 0.5F, 0.25F), ElementsAre(1.375F, 0));
}

TEST(StatedTextures, ReflectionMapsStandUpright) {
  StatedTexture stated{.file = "a.png"};
  for (const bool v_down : {false, true}) {
    stated.v_down = v_down;
    EXPECT_THAT(placed(use_of_stated(stated, kReflectionSlot, Transfer::srgb).use, 0.25F, 0.125F), ElementsAre(0.25F, 0.125F));
  }
}

TEST(StatedTextures, AnEncodedBorderIsDecodedWithColours) {
  StatedTexture stated{.file = "a.png"};
  stated.border = {{0.5F, 0, 1}, ColorSpace::encoded};
  const auto red = [&](std::string_view key, Transfer transfer) { return use_of_stated(stated, slot(key), transfer).use.sampler.border[0]; };
  EXPECT_NEAR(red("diffuse", Transfer::srgb), 0.21404114F, 1e-6F);
  EXPECT_EQ(red("diffuse", Transfer::none), 0.5F);
  EXPECT_EQ(red("bump", Transfer::srgb), 0.5F);
}

TEST(StatedTextures, EveryKeyReachesTheUse) {
  StatedTexture stated{.file = "a.png", .wrap = {Wrap::mirrored_repeat, Wrap::clamp_to_edge}, .magnify = TextureFilter::nearest};
  stated.minify = TextureFilter::nearest;
  stated.mip = MipFilter::none;
  stated.anisotropy = 8;
  stated.uv_set = 1;
  stated.gain = {2, 3, 4};
  stated.base = {-1, 0, 1};
  stated.lod_bias = -2;
  stated.border = {{0.5F, 0.25F, 1}};
  stated.border_alpha = 0.75F;
  stated.channel = TextureChannel::blue;
  stated.once = true;
  const MapUse map = use_of_stated(stated, slot("opacity"), Transfer::srgb);
  EXPECT_EQ(map.use.name, "a.png");
  EXPECT_EQ(map.use.sampler, (Sampler{.wrap_u = Wrap::mirrored_repeat,
                                      .wrap_v = Wrap::clamp_to_edge,
                                      .magnify = TextureFilter::nearest,
                                      .minify = TextureFilter::nearest,
                                      .mip = MipFilter::none,
                                      .anisotropy = 8,
                                      .border = {0.5F, 0.25F, 1, 0.75F},
                                      .lod_bias = -2}));
  EXPECT_EQ(map.use.uv_set, 1);
  EXPECT_EQ(map.use.gain, (Vec3f{2, 3, 4}));
  EXPECT_EQ(map.use.base, (Vec3f{-1, 0, 1}));
  EXPECT_EQ(map.use.channel, 2);
  EXPECT_TRUE(map.states_channel);
  EXPECT_TRUE(map.use.leaves_outside);
  stated.channel = TextureChannel::luminance;
  EXPECT_EQ(use_of_stated(stated, slot("opacity"), Transfer::srgb).use.channel, 4);
  EXPECT_FALSE(use_of_stated({.file = "a.png"}, slot("opacity"), Transfer::srgb).states_channel);
}

}  // namespace
}  // namespace lustro
