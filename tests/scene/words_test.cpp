// Enums and their words.
#include "scene/words.hpp"

#include <gtest/gtest.h>

#include <set>

namespace lustro {
namespace {

template <class E>
class Words : public testing::Test {};
using Enums =
    testing::Types<Lighting, Interpolation, NormalInterpolation, VertexNormals, Culling, Transfer, Projection, ViewPreset, LightType, FogMode>;
TYPED_TEST_SUITE(Words, Enums);

TYPED_TEST(Words, AreUniqueExplainedAndReadBack) {
  std::set<std::string_view> seen;
  std::uint8_t value = 0;
  for (const Word& word : words_of<TypeParam>()) {
    EXPECT_EQ(word.value, value++);  // in the order of the enum
    EXPECT_TRUE(seen.insert(word.word).second) << word.word;
    EXPECT_FALSE(word.help.empty()) << word.word;
    EXPECT_EQ(word_of(static_cast<TypeParam>(word.value)), word.word);
    EXPECT_EQ(parse_word<TypeParam>(word.word).value(), static_cast<TypeParam>(word.value));
  }
  EXPECT_GE(value, 2);
}

TEST(Words, CoverEveryValueOfTheirEnum) {
  EXPECT_EQ(words_of<Lighting>().size(), 5U);
  EXPECT_EQ(words_of<Interpolation>().size(), 3U);
  EXPECT_EQ(words_of<NormalInterpolation>().size(), 2U);
  EXPECT_EQ(words_of<VertexNormals>().size(), 3U);
  EXPECT_EQ(words_of<Culling>().size(), 3U);
  EXPECT_EQ(words_of<Transfer>().size(), 2U);
  EXPECT_EQ(words_of<Projection>().size(), 2U);
  EXPECT_EQ(words_of<ViewPreset>().size(), 8U);
  EXPECT_EQ(words_of<LightType>().size(), 6U);
  EXPECT_EQ(words_of<SpotFade>().size(), 2U);
  EXPECT_EQ(words_of<GltfShading>().size(), 2U);
  EXPECT_EQ(words_of<FogMode>().size(), 3U);
  EXPECT_EQ(term_words().size(), 4U);
}

TEST(Words, AreTheWordsOfTheSceneFile) {
  EXPECT_EQ(word_of(Lighting::blinn_phong), "blinn-phong");
  EXPECT_EQ(word_of(Lighting::constant), "constant");
  EXPECT_EQ(word_of(ViewPreset::three_quarter), "three-quarter");
  EXPECT_EQ(word_of(Interpolation::gouraud), "gouraud");
  EXPECT_EQ(word_of(NormalInterpolation::slerp), "slerp");
  EXPECT_EQ(word_of(VertexNormals::uniform), "uniform");
  EXPECT_EQ(word_of(Transfer::none), "none");
  EXPECT_EQ(word_of(Projection::orthographic), "orthographic");
  EXPECT_EQ(word_of(LightType::directional), "directional");
  EXPECT_EQ(word_of(FogMode::exp2), "exp2");
  EXPECT_EQ(word_of(Lighting::ggx), "ggx");
  EXPECT_EQ(word_of(SpotFade::quadratic), "quadratic");
  EXPECT_EQ(word_of(GltfShading::classic), "classic");
}

TEST(Words, AnUnknownOneListsTheKnownAndSuggestsTheNearest) {
  EXPECT_EQ(parse_word<Lighting>("blin-phong").error().message,
            "unknown word \"blin-phong\", did you mean \"blinn-phong\"? (known: constant, lambert, phong, blinn-phong, ggx)");
  EXPECT_EQ(parse_word<Lighting>("Blinn_Phong").error().message,
            "unknown word \"Blinn_Phong\", did you mean \"blinn-phong\"? (known: constant, lambert, phong, blinn-phong, ggx)");
  EXPECT_EQ(parse_word<Transfer>("linear").error().message, "unknown word \"linear\" (known: none, srgb)");
  EXPECT_EQ(parse_word<Transfer>("").error().kind, ErrorKind::usage);
}

TEST(Words, TermsAreTheMembersOfTermSetInOrder) {
  TermSet terms{false, false, false, false};
  terms.*kTermMembers[find_word(term_words(), "specular")->value] = true;
  EXPECT_EQ(terms, (TermSet{false, false, true, false}));
  terms = {false, false, false, false};
  terms.*kTermMembers[find_word(term_words(), "emission")->value] = true;
  EXPECT_EQ(terms, (TermSet{false, false, false, true}));
}

}  // namespace
}  // namespace lustro
