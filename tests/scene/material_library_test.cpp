// The material library against the table that it was taken from, number by number.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "scene/material_groups.hpp"
#include "shared_dir.hpp"

namespace lustro {
namespace {

std::vector<std::vector<std::string>> read_table(const std::filesystem::path& file) {
  std::vector<std::vector<std::string>> rows;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') {
      continue;
    }
    std::istringstream cells(line);
    std::vector<std::string> row;
    for (std::string cell; std::getline(cells, cell, '\t');) {
      row.push_back(cell);
    }
    rows.push_back(row);
  }
  return rows;
}

TEST(MaterialLibrary, HasEveryNumberOfTheTable) {
  LUSTRO_REQUIRE_SHARED();
  auto rows = read_table(shared_dir() / "data" / "materials.tsv");
  ASSERT_EQ(rows.size(), 30U);
  ASSERT_EQ(rows[0][0], "name");
  rows.erase(rows.begin());
  ASSERT_EQ(material_library().size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& row = rows[i];
    const Material& material = material_library()[i];
    const auto color = [&](std::size_t column) {
      return Color{{std::stof(row[column]), std::stof(row[column + 1]), std::stof(row[column + 2])}, ColorSpace::encoded};
    };
    EXPECT_EQ(material.name, row[0]);
    EXPECT_EQ(material_group_name(material_group(row[0]).value()), row[1]) << row[0];
    EXPECT_EQ(material.ambient, color(2)) << row[0];
    EXPECT_EQ(material.diffuse, color(5)) << row[0];
    EXPECT_EQ(material.specular, color(8)) << row[0];
    EXPECT_EQ(material.emission, (Color{{0, 0, 0}, ColorSpace::encoded})) << row[0];
    EXPECT_EQ(material.shininess, std::stof(row[12])) << row[0];
    EXPECT_NEAR(material.shininess, 128 * std::stof(row[11]), 1e-5F * material.shininess) << row[0];
    EXPECT_EQ(material.opacity, 1) << row[0];
    EXPECT_FALSE(material.lighting) << row[0];
    EXPECT_EQ(library_material(row[0]), material);
  }
}

TEST(MaterialLibrary, HasTheOriginalsWherePublicCopiesAreMisprinted) {
  EXPECT_EQ(library_material("emerald")->ambient.rgb.x, 0.0215F);                     // seen: 0.0125
  EXPECT_EQ(library_material("bronze")->diffuse.rgb.z, 0.18144F);                     // seen: 0.4284
  EXPECT_EQ(library_material("copper")->shininess, 12.8F);                            // seen: 2.8
  EXPECT_EQ(library_material("gold")->ambient.rgb.y, 0.1995F);                        // seen: 0.21995
  EXPECT_EQ(library_material("brass")->shininess, 27.897436F);                        // seen: 0.2179 and 27.8974 * 128
  EXPECT_EQ(library_material("polished_gold")->specular.rgb.y, 0.723991F);            // seen: 0.7233991
  EXPECT_EQ(library_material("cyan_plastic")->ambient.rgb, (Vec3f{0, 0.1F, 0.06F}));  // no misprint
}

TEST(MaterialLibrary, KnowsItsGroupsAndNothingElse) {
  EXPECT_EQ(material_group("jade"), MaterialGroup::gem);
  EXPECT_EQ(material_group("pewter"), MaterialGroup::metal);
  EXPECT_EQ(material_group("red_plastic"), MaterialGroup::plastic);
  EXPECT_EQ(material_group("red_rubber"), MaterialGroup::rubber);
  EXPECT_EQ(material_group("wood"), std::nullopt);
  EXPECT_EQ(library_material("Jade"), std::nullopt);
  EXPECT_EQ(library_material(""), std::nullopt);
}

}  // namespace
}  // namespace lustro
