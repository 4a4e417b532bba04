// MTL, clause by clause.
#include "io/mtl.hpp"

#include <cmath>

#include "io_testing.hpp"

namespace lustro {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

MtlFile mtl(const std::string& text, const MtlOptions& options = {}) {
  return good(parse_mtl(text, "m.mtl", options));
}
Error error_of(const std::string& text) {
  return bad(parse_mtl("newmtl a\n" + text, "m.mtl"));
}

// The one material of a text, and its notes.
struct One {
  Material material;
  std::vector<std::string> notes;
};
One one(const std::string& text, const MtlOptions& options = {}) {
  MtlFile file = mtl("newmtl a\n" + text, options);
  EXPECT_EQ(file.materials.size(), 1U);
  return {file.materials.empty() ? Material{} : file.materials[0], texts(file.notes)};
}
Color encoded(float r, float g, float b) {
  return {{r, g, b}, ColorSpace::encoded};
}

TEST(Mtl, TheClassicStatementsFillTheCoefficients) {
  const One found =
      one("Ka 0.1 0.2 0.3\nKd 0.4 0.5 0.6\nKs 0.7 0.8 0.9\nKe 17 12 4\nNs 96.5\nNi 1.5\nTf 0.1 0.2 0.3\nsharpness 100\nd 0.25\nillum 2\n");
  const Material& m = found.material;
  EXPECT_EQ(m.name, "a");
  EXPECT_EQ(m.ambient, encoded(0.1F, 0.2F, 0.3F));
  EXPECT_EQ(m.diffuse, encoded(0.4F, 0.5F, 0.6F));
  EXPECT_EQ(m.specular, encoded(0.7F, 0.8F, 0.9F));
  EXPECT_EQ(m.emission, encoded(17, 12, 4));
  EXPECT_EQ(m.transmission, encoded(0.1F, 0.2F, 0.3F));
  EXPECT_EQ(m.shininess, 96.5F);
  EXPECT_EQ(m.refraction, 1.5F);
  EXPECT_EQ(m.sharpness, 100);
  EXPECT_EQ(m.opacity, 0.25F);
  EXPECT_EQ(m.illumination, 2);
  EXPECT_EQ(m.lighting, std::nullopt);
  EXPECT_FALSE(m.halo);
  EXPECT_TRUE(found.notes.empty()) << "the renderer says what it does with opacity, not the reader";
}

TEST(Mtl, WhatIsNotStatedKeepsTheDefaults) {
  Material expected;
  expected.name = "a";
  EXPECT_EQ(one("").material, expected);
}

TEST(Mtl, GreenAndBlueDefaultToRed) {
  EXPECT_EQ(one("Kd 0.5\n").material.diffuse, encoded(0.5F, 0.5F, 0.5F));
  EXPECT_EQ(one("Kd 0.5 0.25 # x\n").material.diffuse, encoded(0.5F, 0.25F, 0.5F));
}

TEST(Mtl, SpectralAndXyzColoursAreRefused) {
  for (const char* kind : {"spectral f.rfl 1", "xyz 0.3 0.3 0.3"}) {
    for (const char* statement : {"Ka", "Kd", "Ks", "Ke", "Tf"}) {
      const Error error = error_of(std::string("\n") + statement + " " + kind + "\n");
      EXPECT_EQ(error.kind, ErrorKind::unsupported);
      EXPECT_EQ(error.where, "m.mtl:3");
    }
  }
  EXPECT_EQ(error_of("Kd spectral f.rfl\n").text(), "m.mtl:2: Kd as a spectral colour: only red, green and blue numbers are read");
}

TEST(Mtl, NumbersThatAreNoneAreErrors) {
  EXPECT_EQ(error_of("Kd red\n").text(), "m.mtl:2: Kd expects a finite number, found \"red\"");
  EXPECT_EQ(error_of("Kd\n").text(), "m.mtl:2: Kd expects a finite number, found the end of the line");
  EXPECT_EQ(error_of("Kd 1 2 x\n").text(), "m.mtl:2: Kd expects a finite number, found \"x\"");
  EXPECT_EQ(error_of("Ns\n").text(), "m.mtl:2: Ns expects a finite number, found the end of the line");
  EXPECT_EQ(error_of("illum two\n").text(), "m.mtl:2: illum expects a whole number 0..10, found \"two\"");
  for (const char* text : {"Kd nan\n", "Kd 1 inf\n", "Ns nan\n", "d nan\n", "Tr inf\n"}) {
    EXPECT_EQ(error_of(text).kind, ErrorKind::malformed) << text;
  }
}

TEST(Mtl, NumbersOutsideTheirRangeAreClampedWithANote) {
  const One found = one("Ns 1e6\nNi 0\nd 1.5\nsharpness -1\nKd -1 0.5 0.5\nTr -3\n");
  EXPECT_EQ(found.material.shininess, 10000);
  EXPECT_EQ(found.material.refraction, 0.001F);
  EXPECT_EQ(found.material.opacity, 1);
  EXPECT_EQ(found.material.sharpness, 0);
  EXPECT_EQ(found.material.diffuse, encoded(0, 0.5F, 0.5F));
  EXPECT_THAT(found.notes, ElementsAre("m.mtl:2: Ns: values outside 0..10000 are clamped", "m.mtl:3: Ni: values outside 0.001..10 are clamped",
                                       "m.mtl:4: d: values outside 0..1 are clamped", "m.mtl:5: sharpness: values outside 0..1000 are clamped",
                                       "m.mtl:6: Kd: colours below 0 become 0", "m.mtl:7: Tr: values outside 0..1 are clamped",
                                       "m.mtl:7: Tr beside d is ignored: d states the opacity"));
}

TEST(Mtl, ALoneTrIsTheTransparencyUnlessTheCallerSaysOtherwise) {
  EXPECT_EQ(one("Tr 0.25\n").material.opacity, 0.75F);
  EXPECT_EQ(one("Tr 0.25\n", {.transparency_is_tr = true}).material.opacity, 0.25F);
  EXPECT_EQ(one("Tr 0\n").material.opacity, 1);
  EXPECT_EQ(one("Tr 0\n", {.transparency_is_tr = true}).material.opacity, 0);
}

TEST(Mtl, DWinsOverTrInEitherOrderWithOneNote) {
  for (const bool is_tr : {false, true}) {
    const MtlFile file = mtl("newmtl a\nd 0.75\nTr 0.5\nnewmtl b\nTr 0.5\nd 1\n", {.transparency_is_tr = is_tr});
    EXPECT_EQ(file.materials[0].opacity, 0.75F);
    EXPECT_EQ(file.materials[1].opacity, 1);
    EXPECT_THAT(texts(file.notes), ElementsAre("m.mtl:3: Tr beside d is ignored: d states the opacity (2 times)"));
  }
}

TEST(Mtl, HaloIsKept) {
  const Material m = one("d -halo 0.5\n").material;
  EXPECT_TRUE(m.halo);
  EXPECT_EQ(m.opacity, 0.5F);
}

TEST(Mtl, IllumZeroAndOneSetTheLighting) {
  EXPECT_EQ(one("illum 0\n").material.lighting, Lighting::constant);
  EXPECT_EQ(one("illum 1\n").material.lighting, Lighting::lambert);
  for (int model = 2; model <= 10; ++model) {
    const One found = one("illum " + std::to_string(model) + "\n");
    EXPECT_EQ(found.material.lighting, std::nullopt);
    EXPECT_EQ(found.material.illumination, model);
    EXPECT_EQ(found.notes.size(), model > 2 && model != 8 && model != 10 ? 1U : 0U) << model;  // model 8 asks for its map alone
  }
  EXPECT_EQ(one("illum 0\nillum 2\n").material.lighting, std::nullopt);  // the last one counts
}

TEST(Mtl, ModelsThatNeedRaysFallBackToTheirMapsAndSaySo) {
  EXPECT_THAT(one("illum 3\n").notes,
              ElementsAre("m.mtl:2: illum 3 asks for traced reflections, which the path tracer alone draws: elsewhere drawn as illum 2"));
  EXPECT_THAT(
      one("illum 3\nrefl -type sphere a.png\n").notes,
      ElementsAre("m.mtl:2: illum 3 asks for traced reflections, which the path tracer alone draws: elsewhere its reflection map is drawn"));
  EXPECT_THAT(one("illum 7\nmap_refl a.png\n").notes, ElementsAre("m.mtl:2: illum 7 asks for traced reflections and refraction by Fresnel, "
                                                                  "which the path tracer alone draws: elsewhere its reflection map is drawn"));
  EXPECT_THAT(one("illum 4\n").notes,
              ElementsAre("m.mtl:2: illum 4 asks for traced reflections, which the path tracer alone draws, and highlights that "
                          "hide what lies behind, which are not drawn: elsewhere drawn as illum 2"));
  EXPECT_THAT(one("illum 9\n").notes,
              ElementsAre("m.mtl:2: illum 9 asks for highlights that hide what lies behind, which are not drawn: drawn as illum 2"));
  EXPECT_THAT(one("illum 8\nrefl a.png\n").notes, IsEmpty());
  const One matte = one("d 0.7\nillum 10\n");
  EXPECT_EQ(matte.material.opacity, 0.7F);
  EXPECT_EQ(matte.material.illumination, 10);
  EXPECT_THAT(matte.notes, IsEmpty());
}

TEST(Mtl, IllumOutsideIsIgnoredWithANote) {
  for (const char* text : {"illum 11\n", "illum -1\n"}) {
    const One found = one(text);
    EXPECT_EQ(found.material.illumination, std::nullopt);
    EXPECT_EQ(found.notes.size(), 1U);
  }
}

TEST(Mtl, UnknownStatementsAreANoteEach) {
  EXPECT_THAT(one("Kx 1\nfoo\nKx 2\nmap_aat on\n").notes,
              ElementsAre("m.mtl:2: unknown statement \"Kx\" is ignored (2 times)", "m.mtl:3: unknown statement \"foo\" is ignored"));
}

TEST(Mtl, PhysicallyBasedStatementsAreOneNote) {
  EXPECT_THAT(one("Pr 0.5\nPm 1\nPs 0\nPc 0\nPcr 0\naniso 0\nanisor 0\n").notes,
              ElementsAre("m.mtl:2: statements of physically based shading (Pr, Pm, Ps, Pc, Pcr, aniso, anisor) are ignored (7 times)"));
}

TEST(Mtl, StatementsBeforeTheFirstMaterialAreIgnored) {
  const MtlFile file = mtl("Kd 1 0 0\nnewmtl a\n");
  EXPECT_EQ(file.materials[0].diffuse, Material{}.diffuse);
  EXPECT_THAT(texts(file.notes), ElementsAre("m.mtl:1: statements before the first newmtl are ignored"));
}

TEST(Mtl, AMaterialThatIsStatedTwiceIsTheLast) {
  const MtlFile file = mtl("newmtl a\nKd 1 0 0\nKs 1 1 1\nnewmtl b\nnewmtl a\nKd 0 1 0\n");
  ASSERT_EQ(file.materials.size(), 2U);
  EXPECT_EQ(file.materials[0].diffuse.rgb, (Vec3f{0, 1, 0}));
  EXPECT_EQ(file.materials[0].specular.rgb, (Vec3f{0, 0, 0}));  // nothing is left of the first
  EXPECT_THAT(texts(file.notes), ElementsAre("m.mtl:5: material \"a\" is stated again: the last one counts"));
}

TEST(Mtl, LinesMayBeIndentedJoinedAndEndInAnyWay) {
  for (const char* text :
       {"newmtl a\n\tKd 1 0 0 # red\n  Ns 10", "newmtl a\r\n\tKd 1 \\\r\n0 0\r\n  Ns 10\r\n", "\xEF\xBB\xBFnewmtl a\rKd 1 0 0\rNs 10"}) {
    const MtlFile file = mtl(text);
    EXPECT_EQ(file.materials.at(0).name, "a");
    EXPECT_EQ(file.materials[0].diffuse.rgb, (Vec3f{1, 0, 0}));
    EXPECT_EQ(file.materials[0].shininess, 10);
    EXPECT_THAT(file.notes, IsEmpty());
  }
}

TEST(Mtl, MapsRememberTheLibraryThatStatesThem) {
  const One found = one("map_Kd a.png\nbump b.png\n");
  ASSERT_EQ(found.material.maps.size(), 2U);
  EXPECT_EQ(found.material.maps[1].library, "m.mtl");
  EXPECT_THAT(found.notes, IsEmpty());
}

TEST(Mtl, AColourThatIsNotStatedBesideItsMapCountsAsOne) {
  const One found = one("map_Kd a.png\nmap_ks b.png\nKa 0.5\nmap_Ka c.png\n");
  EXPECT_EQ(found.material.diffuse, encoded(1, 1, 1));
  EXPECT_EQ(found.material.specular, encoded(1, 1, 1));
  EXPECT_EQ(found.material.ambient, encoded(0.5F, 0.5F, 0.5F));
  EXPECT_EQ(found.material.emission, Material().emission);
  EXPECT_EQ(one("Kd 0\nmap_Kd a.png\n").material.diffuse, encoded(0, 0, 0));
}

TEST(Mtl, NamesThatAreNotUtf8AreReadAsLatin1) {
  EXPECT_EQ(mtl("newmtl Gr\xFCn\n").materials[0].name, "Gr\xC3\xBCn");
}

}  // namespace
}  // namespace lustro
