// `lustro materials`.
#include <gmock/gmock.h>

#include "app/run_command.hpp"
#include "lustro/image.hpp"
#include "lustro/material.hpp"

namespace {

using namespace lustro::testing;
using ::testing::HasSubstr;

class MaterialsCommand : public CommandTest {};

TEST_F(MaterialsCommand, ListsAllOfThemByGroup) {
  const Outcome outcome = lustro({"materials"});
  ASSERT_EQ(outcome.code, 0);
  EXPECT_EQ(lustro::material_library().size(), 29U);
  for (const lustro::Material& material : lustro::material_library()) {
    EXPECT_THAT(outcome.out, HasSubstr("  " + material.name + " "));
  }
  const std::size_t gem = outcome.out.find("\ngem\n"), metal = outcome.out.find("\nmetal\n"), rubber = outcome.out.find("\nrubber\n");
  EXPECT_LT(gem, metal);
  EXPECT_LT(metal, rubber);
  EXPECT_LT(outcome.out.find("polished_gold"), outcome.out.find("\nplastic\n"));
}

TEST_F(MaterialsCommand, JsonHasTheNumbersOfTheTable) {
  const auto json = lustro({"materials", "--json"}).json();
  ASSERT_EQ(json.size(), 29U);
  EXPECT_EQ(json[1]["name"], "jade");
  EXPECT_EQ(json[1]["group"], "gem");
  EXPECT_EQ(json[1]["diffuse"]["rgb"], nlohmann::json({0.54, 0.89, 0.63}));
  EXPECT_EQ(json[1]["shininess"], 12.8);
}

TEST_F(MaterialsCommand, TheSheetShowsEachMaterialInItsOwnColour) {
  const Outcome outcome = lustro({"materials", "--sheet", "sheet.png", "-q"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto sheet = lustro::read_image(work() / "sheet.png");
  ASSERT_TRUE(sheet);
  EXPECT_GT(sheet->width, 1000);
  const auto has = [&](auto like) {
    std::size_t count = 0;
    for (int y = 0; y < sheet->height; ++y) {
      for (int x = 0; x < sheet->width; ++x) {
        const auto p = sheet->at(x, y);
        count += like(p[0], p[1], p[2]) ? 1U : 0U;
      }
    }
    return count > 500;
  };
  EXPECT_TRUE(has([](float r, float g, float b) { return r > 0.2F && g < 0.03F && b < 0.03F; })) << "ruby";
  EXPECT_TRUE(has([](float r, float g, float b) { return g > 0.2F && r < 0.08F && b < 0.08F; })) << "emerald";
  EXPECT_TRUE(has([](float r, float g, float b) { return r > 0.3F && g > 0.15F && b < 0.05F; })) << "brass";
  EXPECT_EQ(lustro({"materials", "--sheet", "sheet.gif"}).code, 5);
  EXPECT_EQ(lustro({"materials", "--sheet", "no/sheet.png"}).code, 3);
}

}  // namespace
