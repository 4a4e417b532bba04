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

}  // namespace
