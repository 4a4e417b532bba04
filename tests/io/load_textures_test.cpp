#include "io/load_textures.hpp"

#include "image/srgb.hpp"
#include "io/io_testing.hpp"
#include "io/mtl.hpp"
#include "io/temporary_folder.hpp"
#include "texture/texture.hpp"

namespace lustro {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Image plain(int channels, const std::vector<float>& pixel, int size = 2) {
  Image image(size, size, channels);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = pixel[i % pixel.size()];
  }
  return image;
}

struct Folder : TemporaryFolder {
  void picture(const std::string& name, const Image& image) const { ASSERT_TRUE(write_image(path / name, image, {.transfer = Transfer::none})); }
  /// The materials of an MTL text in this folder, with their textures.
  Result<std::pair<std::vector<Material>, Notes>> load(const std::string& mtl, LoadOptions options = {}) const {
    std::vector<Material> materials = good(parse_mtl(mtl, "m.mtl")).materials;
    TextureCache cache;
    auto notes = load_map_textures(materials, path, options, cache);
    if (!notes) {
      return tl::unexpected(notes.error());
    }
    return std::pair(std::move(materials), *std::move(notes));
  }
};

TEST(LoadTextures, ColoursAreDecodedAndDataIsNot) {
  const Folder folder;
  folder.picture("half.png", plain(3, {0.6F, 0.6F, 0.6F}));
  for (const Transfer transfer : {Transfer::srgb, Transfer::none}) {
    const auto [materials, notes] = good(folder.load("newmtl a\nmap_Kd half.png\nmap_Ns half.png\n", {.transfer = transfer}));
    EXPECT_THAT(texts(notes), IsEmpty());
    const MaterialTextures& textures = materials[0].textures;
    ASSERT_TRUE(textures.diffuse && textures.shininess);
    EXPECT_NEAR(textures.diffuse->texture->texel(0, 0, 0)[0], transfer == Transfer::srgb ? srgb_decode(0.6F) : 0.6F, 1e-4);
    EXPECT_NEAR(textures.shininess->texture->texel(0, 0, 0)[0], 0.6F, 1e-4);
  }
}

TEST(LoadTextures, AFileIsReadOnceForEachMeaning) {
  const Folder folder;
  folder.picture("a.png", plain(1, {0.5F}));
  const auto [materials, notes] =
      good(folder.load("newmtl a\nmap_Kd a.png\nmap_Ks ./a.png\nmap_d a.png\nnewmtl b\nmap_Kd a.png\nmap_Ns a.png\n"));
  const Texture* const color = materials[0].textures.diffuse->texture.get();
  EXPECT_EQ(materials[0].textures.specular->texture.get(), color);
  EXPECT_EQ(materials[1].textures.diffuse->texture.get(), color);
  const Texture* const data = materials[0].textures.opacity->texture.get();
  EXPECT_NE(data, color);
  EXPECT_EQ(materials[1].textures.shininess->texture.get(), data);
}

TEST(LoadTextures, ThePictureDecidesWhichChannelAnUnstatedOneIs) {
  const Folder folder;
  folder.picture("gray.png", plain(1, {0.5F}));
  folder.picture("color.png", plain(3, {0.5F, 0.25F, 0.5F}));
  folder.picture("alpha.png", plain(4, {0.25F, 0.25F, 0.25F, 0.5F}));
  const auto channel = [&](const std::string& line) {
    const auto [materials, notes] = good(folder.load("newmtl a\n" + line + "\n"));
    const auto& textures = materials[0].textures;
    return static_cast<int>((textures.opacity ? textures.opacity : textures.bump)->channel);
  };
  EXPECT_EQ(channel("map_d gray.png"), 0);
  EXPECT_EQ(channel("map_d color.png"), 4);
  EXPECT_EQ(channel("map_d alpha.png"), 3);
  EXPECT_EQ(channel("map_d -imfchan l alpha.png"), 4);
  EXPECT_EQ(channel("bump gray.png"), 0);
  EXPECT_EQ(channel("bump alpha.png"), 4);
  EXPECT_THAT(texts(good(folder.load("newmtl a\nmap_d alpha.png\n")).second),
              ElementsAre("m.mtl: map_d: \"alpha.png\" has an alpha, which is used, and not its colours"));
}

TEST(LoadTextures, ADecalHasTheChannelThatIsStatedAsItsAlpha) {
  const Folder folder;
  folder.picture("a.png", plain(4, {0.2F, 0.4F, 0.1F, 0.8F}));  // premultiplied: (0.25, 0.5, 0.125)
  const auto alpha = [&](const std::string& options) {
    const auto [materials, notes] = good(folder.load("newmtl a\ndecal " + options + " a.png\n", {.transfer = Transfer::none}));
    return materials[0].textures.decal->texture->texel(0, 0, 0)[3];
  };
  EXPECT_NEAR(alpha(""), 0.8F, 0.003);
  EXPECT_NEAR(alpha("-imfchan g"), 0.5F, 0.003);
  EXPECT_NEAR(alpha("-imfchan l"), 0.2126F * 0.25F + 0.7152F * 0.5F + 0.0722F * 0.125F, 0.003);
}

TEST(LoadTextures, ABumpMapOfNormalsIsANormalMap) {
  const Folder folder;
  folder.picture("n.png", plain(3, {0.5F, 0.6F, 0.98F}));
  folder.picture("h.png", plain(3, {0.5F, 0.5F, 0.5F}));
  const auto [materials, notes] =
      good(folder.load("newmtl a\nmap_Bump -bm 0.5 n.png\nnewmtl b\nbump h.png\nnewmtl c\nbump n.png\nnorm n.png\n"
                       "newmtl d\nbump -imfchan r n.png\n"));
  EXPECT_TRUE(materials[0].textures.normal);
  EXPECT_FALSE(materials[0].textures.bump);
  EXPECT_EQ(materials[0].textures.normal->gain, (Vec3f{0.5F, 0.5F, 1}));
  EXPECT_TRUE(materials[1].textures.bump);
  EXPECT_FALSE(materials[1].textures.normal);
  EXPECT_TRUE(materials[2].textures.normal);
  EXPECT_FALSE(materials[2].textures.bump);
  EXPECT_TRUE(materials[3].textures.bump);  // whoever states a channel means heights
  EXPECT_THAT(texts(notes), ElementsAre("m.mtl: map_Bump: \"n.png\" holds normals and no heights: it is used as a normal map",
                                        "m.mtl: bump: \"n.png\" holds normals, and the material has a normal map: it is left out"));
}

TEST(HoldsNormals, NormalsAreBluishAndOfUnitLength) {
  EXPECT_TRUE(holds_normals(plain(3, {0.5F, 0.5F, 1})));
  EXPECT_TRUE(holds_normals(plain(4, {0.75F, 0.5F, 0.93F, 1})));
  EXPECT_FALSE(holds_normals(plain(1, {0.8F})));
  EXPECT_FALSE(holds_normals(plain(3, {0.8F, 0.8F, 0.8F})));  // gray, though of unit length: sqrt(3) 0.6 = 1.04
  EXPECT_FALSE(holds_normals(plain(3, {0, 0, 1})));           // plain blue: sqrt(3)
  EXPECT_FALSE(holds_normals(plain(3, {0.4F, 0.5F, 0.7F})));  // a pale sky: 0.45
  EXPECT_FALSE(holds_normals(plain(3, {1, 0.5F, 0.5F})));     // unit, but along the surface
  Image mixed = plain(3, {0.5F, 0.5F, 1}, 10);
  for (std::size_t i = 0; i < 30; ++i) {
    mixed.pixels[i] = 0.5F;  // a tenth of the texels is of no length
  }
  EXPECT_TRUE(holds_normals(mixed));
  mixed.pixels[32] = 0.5F;
  EXPECT_FALSE(holds_normals(mixed));
}

TEST(LoadTextures, BrokenPicturesAreANoteOrAnErrorAndTheMaterialStays) {
  const Folder folder;
  folder.write("broken.png", "\x89PNG\r\n\x1a\n and then nothing");
  folder.write("text.jpg", "no picture");
  const std::string mtl = "newmtl a\nKd 1 0 0\nmap_Kd broken.png\nmap_Ks text.jpg\n";
  const auto [materials, notes] = good(folder.load(mtl));
  EXPECT_FALSE(materials[0].textures.diffuse);
  EXPECT_FALSE(materials[0].textures.specular);
  EXPECT_EQ(materials[0].diffuse.rgb, (Vec3f{1, 0, 0}));
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_THAT(notes[0].text(), HasSubstr("broken.png: the PNG header is broken"));
  EXPECT_THAT(notes[0].text(), testing::EndsWith("; drawn without it"));
  EXPECT_THAT(notes[1].text(), HasSubstr("text.jpg: is no JPEG file"));
  const auto strict = folder.load(mtl, {.strict = true});
  ASSERT_FALSE(strict);
  EXPECT_EQ(strict.error().kind, ErrorKind::malformed);
  EXPECT_THAT(strict.error().text(), testing::EndsWith("(map_Kd of m.mtl)"));
}

TEST(LoadTextures, TheLastOfTwoMapsForOnePlaceCounts) {
  const Folder folder;
  folder.picture("a.png", plain(1, {0.5F}, 2));
  folder.picture("b.png", plain(1, {0.5F}, 3));
  const auto [materials, notes] = good(folder.load("newmtl a\nmap_d a.png\nmap_Tr b.png\n"));
  EXPECT_EQ(materials[0].textures.opacity->texture->width(), 3);
  EXPECT_THAT(texts(notes), ElementsAre("m.mtl: map_Tr: a material that states two maps for its opacity has the last one"));
}

TEST(LoadTextures, TheResultIsTheSameForAnyNumberOfThreads) {
  const Folder folder;
  std::string mtl;
  for (int i = 0; i < 9; ++i) {
    const std::string name = "t" + std::to_string(i) + ".png";
    folder.picture(name, plain(3, {0.1F * static_cast<float>(i), 0.5F, 0.25F}, i + 1));
    mtl += "newmtl m" + std::to_string(i) + "\nmap_Kd " + name + "\nmap_Ks gone" + std::to_string(i) + ".png\n";
  }
  const auto one = good(folder.load(mtl, {.threads = 1}));
  const auto four = good(folder.load(mtl, {.threads = 4}));
  EXPECT_EQ(texts(one.second), texts(four.second));
  for (std::size_t i = 0; i < 9; ++i) {
    const auto& a = one.first[i].textures.diffuse->texture;
    const auto& b = four.first[i].textures.diffuse->texture;
    EXPECT_EQ(a->width(), static_cast<int>(i) + 1);
    EXPECT_EQ(a->texel(0, 0, 0), b->texel(0, 0, 0));
  }
}

TEST(LoadTextures, AllPicturesTogetherStayWithinTheBudget) {
  const TemporaryFolder folder;
  std::string mtl;
  for (int i = 0; i < 3; ++i) {  // 8 x 8 light: 16 bits, with levels of 4, 2 and 1, a column more each: 72 + 20 + 6 + 2 texels of 8 bytes
    ASSERT_TRUE(write_image(folder.path / ("t" + std::to_string(i) + ".png"), plain(3, {0.25F, 0.5F, 0.75F}, 8), {}));
    mtl += "newmtl m" + std::to_string(i) + "\nmap_Kd t" + std::to_string(i) + ".png\n";
  }
  for (const int threads : {1, 4}) {
    std::vector<Material> materials = good(parse_mtl(mtl, "m.mtl")).materials;
    TextureCache cache;
    const std::uint64_t bytes = [&] {
      std::vector<Material> free = materials;
      EXPECT_THAT(good(load_map_textures(free, folder.path, {.threads = threads}, cache)), testing::IsEmpty());
      return free[0].textures.diffuse->texture->byte_count();
    }();
    EXPECT_GE(bytes, 100U * 8U);
    TextureCache small;
    small.budget = TextureBudget(2 * bytes + 1);
    const Notes notes = good(load_map_textures(materials, folder.path, {.threads = threads}, small));
    EXPECT_TRUE(materials[0].textures.diffuse && materials[1].textures.diffuse);
    EXPECT_FALSE(materials[2].textures.diffuse);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_THAT(notes[0].text(),
                testing::HasSubstr("8 x 8 texels with their smaller levels take " + std::to_string(bytes) + " bytes; of the " +
                                   std::to_string(2 * bytes + 1) + " that all textures may take together 1 are left; drawn without it"));
    TextureCache strict;
    strict.budget = TextureBudget(2 * bytes);
    std::vector<Material> again = good(parse_mtl(mtl, "m.mtl")).materials;
    const Result<Notes> error = load_map_textures(again, folder.path, {.strict = true, .threads = threads}, strict);
    ASSERT_FALSE(error);
    EXPECT_EQ(error.error().kind, ErrorKind::limit);
  }
}

TEST(LoadTextures, SixStatementsAreOneCube) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_image(folder.path / "a.png", Image(1, 1, 3), {}));
  std::vector<Material> materials = good(parse_mtl("newmtl m\nillum 3\nrefl -type cube_top a.png\nrefl -type cube_back a.png\n"
                                                   "refl -type sphere a.png\ndisp a.png\n",
                                                   "m.mtl"))
                                        .materials;
  TextureCache cache;
  const Notes notes = good(load_map_textures(materials, folder.path, {}, cache));
  const auto& map = materials[0].textures.reflection;
  ASSERT_TRUE(map);
  EXPECT_EQ(map->shape, ReflectionShape::cube);
  EXPECT_TRUE(map->faces[2] && map->faces[5]);
  EXPECT_FALSE(map->faces[0] || map->faces[1] || map->faces[3] || map->faces[4]);
  EXPECT_TRUE(materials[0].textures.displacement);
  EXPECT_THAT(texts(notes), ElementsAre("m.mtl: refl: \"a.png\" is left out: a material reflects a sphere or a cube, and the first one counts"));
}

}  // namespace
}  // namespace lustro
