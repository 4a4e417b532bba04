// Map statements and their options.
#include "io/mtl_map.hpp"

#include "io_testing.hpp"

namespace lustro {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TextureMap map(const std::string& rest) {
  NoteBook notes("m.mtl");
  const std::optional<TextureMap> found = parse_map("map_Kd", rest, 3, notes);
  EXPECT_TRUE(found) << rest;
  EXPECT_THAT(notes.notes(), IsEmpty()) << rest;
  return found.value_or(TextureMap{});
}

TextureMap plain(std::string file) {
  TextureMap map;
  map.statement = "map_Kd";
  map.file = std::move(file);
  return map;
}

TEST(MtlMap, TheStatementsOfTheFormatAndOfExportersAreKnown) {
  for (const char* word : {"map_Ka", "map_Kd", "map_Ks", "map_Ke", "map_Ns", "map_d", "map_bump", "map_Bump", "bump", "disp", "decal", "refl",
                           "norm", "map_Pr", "map_Tr", "map_refl", "map_kd", "map_Pcr"}) {
    EXPECT_TRUE(is_map_statement(word)) << word;
  }
  for (const char* word : {"map", "map_", "map_aat", "Kd", "map_Kdd", "bumps", "map_aaaaaaaaaaaaaaaaaaaaaaaaaaaaa"}) {
    EXPECT_FALSE(is_map_statement(word)) << word;
  }
}

TEST(MtlMap, ABareNameHasTheDefaultOptions) {
  EXPECT_EQ(map("wood.png"), plain("wood.png"));
  EXPECT_EQ(map("my wood  1.png"), plain("my wood  1.png"));
  EXPECT_EQ(map("\"my wood.png\""), plain("my wood.png"));
  EXPECT_EQ(map(".\\maps\\wood.jpg"), plain(".\\maps\\wood.jpg"));
}

TEST(MtlMap, EveryOptionIsRead) {
  TextureMap expected = plain("w.png");
  expected.blend_u = false;
  expected.blend_v = false;
  expected.boost = 2.5F;
  expected.color_correction = true;
  expected.clamp = true;
  expected.channel = 'l';
  expected.base = 0.1F;
  expected.gain = 0.9F;
  expected.offset = {1, 2, 3};
  expected.scale = {4, 5, 6};
  expected.turbulence = {7, 8, 9};
  expected.texture_resolution = 512;
  expected.bump_multiplier = 0.5F;
  expected.type = "cube_top";
  const std::string options =
      "-blendu off -blendv off -boost 2.5 -cc on -clamp on -imfchan l -mm 0.1 0.9 -o 1 2 3 -s 4 5 6 -t 7 8 9 -texres 512 -bm 0.5 -type cube_top";
  EXPECT_EQ(map(options + " w.png"), expected);
  EXPECT_EQ(map("w.png " + options), expected);
  EXPECT_EQ(map("-blendu off -type cube_top -boost 2.5 w.png " + options), expected);
}

TEST(MtlMap, VectorsMayBeShort) {
  EXPECT_EQ(map("-o 0.5 w.png").offset, (Vec3f{0.5F, 0, 0}));
  EXPECT_EQ(map("-s 2 3 w.png").scale, (Vec3f{2, 3, 1}));
  EXPECT_EQ(map("-s 2 3 3dwood.png").file, "3dwood.png");  // a name may begin with a digit
}

TEST(MtlMap, NamesMayLookLikeOptions) {
  EXPECT_EQ(map("a -s b.png"), plain("a -s b.png"));
  EXPECT_EQ(map("-clamp.png"), plain("-clamp.png"));
  EXPECT_EQ(map("-clamp on -clamp.png").file, "-clamp.png");
  EXPECT_EQ(map("wood - old.png"), plain("wood - old.png"));
  EXPECT_EQ(map("-type disc w.png"), plain("-type disc w.png"));
}

TEST(MtlMap, WithoutANameThereIsNoMap) {
  for (const char* rest : {"", "-clamp on", "-s 1 1 1 -o 0 0 0"}) {
    NoteBook notes("m.mtl");
    EXPECT_FALSE(parse_map("map_Kd", rest, 3, notes));
    EXPECT_THAT(texts(notes.notes()), ElementsAre("m.mtl:3: map_Kd names no file and is ignored"));
  }
}

TEST(MtlMap, TextBehindTheOptionsIsIgnoredWithANote) {
  NoteBook notes("m.mtl");
  EXPECT_EQ(parse_map("map_Kd", "a b.png -clamp on c.png", 3, notes)->file, "a b.png");
  EXPECT_THAT(texts(notes.notes()), ElementsAre("m.mtl:3: map_Kd: \"c.png\" behind the options is ignored"));
}

}  // namespace
}  // namespace lustro
