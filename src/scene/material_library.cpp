// The classic material library: the 24 materials of Mark J. Kilgard's teapots.c (Silicon Graphics 1993, 1994; Red Book and Mesa demos) and the
// five that only Blythe and McReynolds' "Advanced Graphics Programming Techniques Using OpenGL" (SIGGRAPH 1998 to 2000) has. The misprints of
// later copies are not here. Opacity is 1 for all, as teapots.c has it; the exponent is 128 times the table's shininess.
#include <array>
#include <string_view>

#include "scene/material_groups.hpp"

namespace lustro {
namespace {

struct Row {
  std::string_view name;
  MaterialGroup group;
  Vec3f ambient, diffuse, specular;
  float shininess;  // the exponent n
};

using enum MaterialGroup;

// clang-format off
constexpr std::array<Row, 29> kRows{{
    {"emerald", gem, {0.0215F, 0.1745F, 0.0215F}, {0.07568F, 0.61424F, 0.07568F}, {0.633F, 0.727811F, 0.633F}, 76.8F},
    {"jade", gem, {0.135F, 0.2225F, 0.1575F}, {0.54F, 0.89F, 0.63F}, {0.316228F, 0.316228F, 0.316228F}, 12.8F},
    {"obsidian", gem, {0.05375F, 0.05F, 0.06625F}, {0.18275F, 0.17F, 0.22525F}, {0.332741F, 0.328634F, 0.346435F}, 38.4F},
    {"pearl", gem, {0.25F, 0.20725F, 0.20725F}, {1.0F, 0.829F, 0.829F}, {0.296648F, 0.296648F, 0.296648F}, 11.264F},
    {"ruby", gem, {0.1745F, 0.01175F, 0.01175F}, {0.61424F, 0.04136F, 0.04136F}, {0.727811F, 0.626959F, 0.626959F}, 76.8F},
    {"turquoise", gem, {0.1F, 0.18725F, 0.1745F}, {0.396F, 0.74151F, 0.69102F}, {0.297254F, 0.30829F, 0.306678F}, 12.8F},
    {"brass", metal, {0.329412F, 0.223529F, 0.027451F}, {0.780392F, 0.568627F, 0.113725F}, {0.992157F, 0.941176F, 0.807843F}, 27.897436F},
    {"bronze", metal, {0.2125F, 0.1275F, 0.054F}, {0.714F, 0.4284F, 0.18144F}, {0.393548F, 0.271906F, 0.166721F}, 25.6F},
    {"chrome", metal, {0.25F, 0.25F, 0.25F}, {0.4F, 0.4F, 0.4F}, {0.774597F, 0.774597F, 0.774597F}, 76.8F},
    {"copper", metal, {0.19125F, 0.0735F, 0.0225F}, {0.7038F, 0.27048F, 0.0828F}, {0.256777F, 0.137622F, 0.086014F}, 12.8F},
    {"gold", metal, {0.24725F, 0.1995F, 0.0745F}, {0.75164F, 0.60648F, 0.22648F}, {0.628281F, 0.555802F, 0.366065F}, 51.2F},
    {"silver", metal, {0.19225F, 0.19225F, 0.19225F}, {0.50754F, 0.50754F, 0.50754F}, {0.508273F, 0.508273F, 0.508273F}, 51.2F},
    {"black_plastic", plastic, {0.0F, 0.0F, 0.0F}, {0.01F, 0.01F, 0.01F}, {0.5F, 0.5F, 0.5F}, 32.0F},
    {"cyan_plastic", plastic, {0.0F, 0.1F, 0.06F}, {0.0F, 0.50980392F, 0.50980392F}, {0.50196078F, 0.50196078F, 0.50196078F}, 32.0F},
    {"green_plastic", plastic, {0.0F, 0.0F, 0.0F}, {0.1F, 0.35F, 0.1F}, {0.45F, 0.55F, 0.45F}, 32.0F},
    {"red_plastic", plastic, {0.0F, 0.0F, 0.0F}, {0.5F, 0.0F, 0.0F}, {0.7F, 0.6F, 0.6F}, 32.0F},
    {"white_plastic", plastic, {0.0F, 0.0F, 0.0F}, {0.55F, 0.55F, 0.55F}, {0.7F, 0.7F, 0.7F}, 32.0F},
    {"yellow_plastic", plastic, {0.0F, 0.0F, 0.0F}, {0.5F, 0.5F, 0.0F}, {0.6F, 0.6F, 0.5F}, 32.0F},
    {"black_rubber", rubber, {0.02F, 0.02F, 0.02F}, {0.01F, 0.01F, 0.01F}, {0.4F, 0.4F, 0.4F}, 10.0F},
    {"cyan_rubber", rubber, {0.0F, 0.05F, 0.05F}, {0.4F, 0.5F, 0.5F}, {0.04F, 0.7F, 0.7F}, 10.0F},
    {"green_rubber", rubber, {0.0F, 0.05F, 0.0F}, {0.4F, 0.5F, 0.4F}, {0.04F, 0.7F, 0.04F}, 10.0F},
    {"red_rubber", rubber, {0.05F, 0.0F, 0.0F}, {0.5F, 0.4F, 0.4F}, {0.7F, 0.04F, 0.04F}, 10.0F},
    {"white_rubber", rubber, {0.05F, 0.05F, 0.05F}, {0.5F, 0.5F, 0.5F}, {0.7F, 0.7F, 0.7F}, 10.0F},
    {"yellow_rubber", rubber, {0.05F, 0.05F, 0.0F}, {0.5F, 0.5F, 0.4F}, {0.7F, 0.7F, 0.04F}, 10.0F},
    {"polished_bronze", metal, {0.25F, 0.148F, 0.06475F}, {0.4F, 0.2368F, 0.1036F}, {0.774597F, 0.458561F, 0.200621F}, 76.8F},
    {"polished_copper", metal, {0.2295F, 0.08825F, 0.0275F}, {0.5508F, 0.2118F, 0.066F}, {0.580594F, 0.223257F, 0.0695701F}, 51.2F},
    {"polished_gold", metal, {0.24725F, 0.2245F, 0.0645F}, {0.34615F, 0.3143F, 0.0903F}, {0.797357F, 0.723991F, 0.208006F}, 83.2F},
    {"pewter", metal, {0.105882F, 0.058824F, 0.113725F}, {0.427451F, 0.470588F, 0.541176F}, {0.333333F, 0.333333F, 0.521569F}, 9.84615F},
    {"polished_silver", metal, {0.23125F, 0.23125F, 0.23125F}, {0.2775F, 0.2775F, 0.2775F}, {0.773911F, 0.773911F, 0.773911F}, 89.6F},
}};
// clang-format on

std::vector<Material> make_library() {
  std::vector<Material> library;
  for (const Row& row : kRows) {
    Material material;
    material.name = std::string(row.name);
    material.ambient = {row.ambient, ColorSpace::encoded};
    material.diffuse = {row.diffuse, ColorSpace::encoded};
    material.specular = {row.specular, ColorSpace::encoded};
    material.emission = {{0, 0, 0}, ColorSpace::encoded};
    material.shininess = row.shininess;
    library.push_back(std::move(material));
  }
  return library;
}

}  // namespace

const std::vector<Material>& material_library() {
  static const std::vector<Material> library = make_library();  // made once, never changed
  return library;
}

std::optional<Material> library_material(std::string_view name) {
  for (const Material& material : material_library()) {
    if (material.name == name) {
      return material;
    }
  }
  return std::nullopt;
}

std::optional<MaterialGroup> material_group(std::string_view name) {
  for (const Row& row : kRows) {
    if (row.name == name) {
      return row.group;
    }
  }
  return std::nullopt;
}

std::string_view material_group_name(MaterialGroup group) {
  switch (group) {
    case gem:
      return "gem";
    case metal:
      return "metal";
    case plastic:
      return "plastic";
    case rubber:
      return "rubber";
  }
  return {};
}

}  // namespace lustro
