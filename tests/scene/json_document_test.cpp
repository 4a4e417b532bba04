// JSON texts: broken ones with their place, limits, duplicate keys.
#include "scene/json_document.hpp"

#include <gtest/gtest.h>

#include "scene_examples.hpp"

namespace lustro {
namespace {

std::string error_of(std::string_view text, const JsonLimits& limits = {}) {
  const auto document = parse_json(text, "s.json", limits);
  return document ? "" : document.error().text();
}

TEST(JsonDocument, SaysWhereATextIsBrokenAndWhatWasExpected) {
  EXPECT_EQ(error_of(""), "s.json:1:1: broken JSON: unexpected end of input, expected a value");
  EXPECT_EQ(error_of("{"), "s.json:1:2: broken JSON: unexpected end of input, expected a key in quotes");
  EXPECT_EQ(error_of("{\"a\" 1}"), "s.json:1:6: broken JSON: unexpected number literal, expected ':'");
  EXPECT_EQ(error_of("{\n \"objects\": [],\n}"), "s.json:3:1: broken JSON: unexpected '}', expected a key in quotes");
  EXPECT_EQ(error_of("{\n  \"a\": tru\n}"), "s.json:2:8: broken JSON: found \"tru\", expected a value");
  EXPECT_EQ(error_of("{\"a\": NaN}"), "s.json:1:7: broken JSON: found \"NaN\", expected a value");
  EXPECT_EQ(error_of("{\"a\": 1.}"), "s.json:1:7: broken JSON: found \"1.\", expected a number");
  EXPECT_EQ(error_of("{\"a\": 1e999}"), "s.json:1:7: broken JSON: the number \"1e999\" is too large");
  EXPECT_EQ(error_of("{} x"), "s.json:1:4: broken JSON: found \"x\", expected end of input");
  EXPECT_EQ(error_of("// no comments\n{}"), "s.json:1:1: broken JSON: found \"//\", expected a value");
  EXPECT_EQ(error_of("{\"a\": \"x"), "s.json:1:9: broken JSON: invalid string: missing closing quote");
  EXPECT_EQ(error_of("{\"a\": \"\xff\"}"), "s.json:1:8: broken JSON: invalid string: ill-formed UTF-8 byte");
}

TEST(JsonDocument, RefusesAKeyThatIsStatedTwice) {
  EXPECT_EQ(error_of(R"({"a": 1, "a": 1})"), "s.json: a: is stated twice");
  EXPECT_EQ(error_of(R"({"a": [{}, {"b": 1, "c d": [1], "c d": 2}]})"), "s.json: a[1][\"c d\"]: is stated twice");
  EXPECT_EQ(error_of(R"([[0, {"x": {"y": 1, "y": 2}}]])"), "s.json: [0][1].x.y: is stated twice");
  EXPECT_EQ(error_of(R"({"a": {"b": 1}, "b": {"b": 1}})"), "");
}

TEST(JsonDocument, KeepsItsLimits) {
  EXPECT_EQ(error_of(std::string(64, '[') + std::string(64, ']')), "");
  EXPECT_EQ(error_of(std::string(65, '[') + std::string(65, ']')), "s.json: has lists and tables nested deeper than 64");
  EXPECT_EQ(error_of(std::string(1 << 20, '[')), "s.json: has lists and tables nested deeper than 64");
  EXPECT_EQ(error_of("[1, 2, 3]", {.values = 4}), "");
  EXPECT_EQ(error_of("[1, 2, 3]", {.values = 3}), "s.json: has more than 3 values");
  EXPECT_EQ(error_of("{\"a\": {}}", {.values = 1}), "s.json: has more than 1 values");
  EXPECT_EQ(error_of("[1]", {.bytes = 2}), "s.json: has 3 bytes, the largest JSON text that is read has 2");
  EXPECT_EQ(JsonLimits{}.bytes, 268435456U);
}

TEST(JsonDocument, BuildsTheTree) {
  const auto document = parse_json(R"({"a": [1, -2, 3.5, true, null, "x\u00fc"], "b": {"c": {}}})", "s.json").value();
  EXPECT_EQ(document["a"].size(), 6U);
  EXPECT_EQ(document["a"][1], -2);
  EXPECT_EQ(document["a"][2], 3.5);
  EXPECT_EQ(document["a"][3], true);
  EXPECT_TRUE(document["a"][4].is_null());
  EXPECT_EQ(document["a"][5], "x\xc3\xbc");
  EXPECT_TRUE(document["b"]["c"].is_object());
}

TEST(JsonDocument, EveryPrefixOfASceneFailsCleanly) {
  for (std::size_t length = 0; length < kExampleScene.size(); ++length) {
    const auto document = parse_json(std::string_view(kExampleScene).substr(0, length), "s.json");
    ASSERT_FALSE(document) << length;
    EXPECT_TRUE(document.error().where.starts_with("s.json:")) << length;
    EXPECT_TRUE(document.error().message.starts_with("broken JSON: ")) << length << document.error().text();
  }
  EXPECT_TRUE(parse_json(kExampleScene, "s.json"));
}

}  // namespace
}  // namespace lustro
