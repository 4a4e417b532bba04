// The page docs/using/scene-file.md: its tables are those of the program, its examples parse. LUSTRO_UPDATE_DOCS=1 writes the tables anew.
#include "scene/key_table.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "lustro/scene.hpp"
#include "scene/fields.hpp"

namespace lustro {
namespace {

const std::filesystem::path kPage = std::filesystem::path(LUSTRO_SOURCE_DIR) / "docs" / "using" / "scene-file.md";
constexpr std::string_view kBegin = "<!-- tables of keys: made by the program, checked by a test -->\n\n";

std::string read(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

TEST(KeyTable, ThePageHasTheProgramsTables) {
  const std::string page = read(kPage);
  const std::size_t begin = page.find(kBegin);
  ASSERT_NE(begin, std::string::npos) << kPage;
  const std::string expected = page.substr(0, begin + kBegin.size()) + key_tables_markdown();
  if (std::getenv("LUSTRO_UPDATE_DOCS") != nullptr) {
    std::ofstream(kPage, std::ios::binary) << expected;
  }
  EXPECT_EQ(read(kPage), expected) << "run this test with LUSTRO_UPDATE_DOCS=1 to write the tables anew";
}

TEST(KeyTable, HasALineForEveryKeyAndWord) {
  const std::string tables = key_tables_markdown();
  for (const FieldGroup& group : field_groups()) {
    EXPECT_TRUE(group.path.empty() || tables.find("### `" + std::string(group.path) + "`") != std::string::npos) << group.path;
    for (const FieldInfo& field : group.fields) {
      EXPECT_NE(tables.find("| `" + std::string(field.key) + "` | "), std::string::npos) << field.key;
      for (const Word& word : field.words) {
        EXPECT_NE(tables.find("- `" + std::string(field.key) + ": " + std::string(word.word) + "`: "), std::string::npos) << word.word;
      }
    }
  }
}

TEST(KeyTable, EveryExampleOfThePageIsAScene) {
  const std::string page = read(kPage);
  constexpr std::string_view kFence = "```json\n";
  int examples = 0;
  for (std::size_t at = page.find(kFence); at != std::string::npos; at = page.find(kFence, at + 1)) {
    const std::size_t begin = at + kFence.size();
    const std::string example = page.substr(begin, page.find("```", begin) - begin);
    auto scene = parse_scene(example, "example");
    ASSERT_TRUE(scene) << scene.error().text() << "\n" << example;
    EXPECT_TRUE(parse_scene(scene_json(*scene)));
    ++examples;
  }
  EXPECT_EQ(examples, 8);
}

TEST(ExampleScenes, AreScenesWithEveryKindOfLightFogAndCamera) {
  int scenes = 0;
  std::array<bool, 6> has_type{};  // one a LightType
  bool has_fog = false;
  bool has_orthographic = false;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(LUSTRO_SOURCE_DIR) / "examples" / "scenes")) {
    const auto scene = parse_scene(read(entry.path()), entry.path().filename().string());
    ASSERT_TRUE(scene) << scene.error().text();
    EXPECT_FALSE(scene->objects.empty()) << entry.path();
    for (const Object& object : scene->objects) {
      EXPECT_TRUE(object.source.starts_with("primitive:") || std::filesystem::exists(entry.path().parent_path() / object.source))
          << object.source;
    }
    for (const Light& light : scene->lights.value_or(std::vector<Light>{})) {
      has_type[static_cast<std::size_t>(light.type)] = true;
    }
    has_fog = has_fog || scene->fog.has_value();
    has_orthographic = has_orthographic || scene->camera.projection == Projection::orthographic;
    ++scenes;
  }
  EXPECT_GE(scenes, 5);
  EXPECT_TRUE(has_type[0] && has_type[1] && has_type[2] && has_fog && has_orthographic);
}

}  // namespace
}  // namespace lustro
