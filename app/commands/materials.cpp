// `lustro materials`: the library of classic materials, as a list, as JSON, and as a picture of them all.
#include <fmt/format.h>

#include "app/commands.hpp"
#include "app/json_out.hpp"
#include "app/material_sheet.hpp"
#include "app/outputs.hpp"
#include "app/progress.hpp"
#include "lustro/material.hpp"
#include "scene/material_groups.hpp"
#include "scene/text_values.hpp"

namespace lustro::app {
namespace {

struct MaterialsFlags {
  std::string sheet;
};

std::string group_of(const Material& material) {
  const std::optional<MaterialGroup> group = material_group(material.name);
  return group ? std::string(material_group_name(*group)) : std::string();
}

/// The groups in the order of the table, each once.
std::vector<std::string> groups() {
  std::vector<std::string> names;
  for (const Material& material : material_library()) {
    if (std::string group = group_of(material); std::find(names.begin(), names.end(), group) == names.end()) {
      names.push_back(std::move(group));
    }
  }
  return names;
}

std::string color_columns(const Color& color) {
  return fmt::format("{:<9.6} {:<9.6} {:<9.6}", color.rgb.x, color.rgb.y, color.rgb.z);
}

std::string list_text() {
  std::string text = fmt::format("{:<18}{:<31}{:<31}{:<31}{}\n", "", "ambient", "diffuse", "specular", "shininess");
  for (const std::string& group : groups()) {
    text += group + "\n";
    for (const Material& material : material_library()) {
      if (group_of(material) == group) {
        text += fmt::format("  {:<16}{}  {}  {}  {}\n", material.name, color_columns(material.ambient), color_columns(material.diffuse),
                            color_columns(material.specular), number_text(material.shininess));
      }
    }
  }
  return text;
}

Json list_json() {
  Json json = Json::array();
  for (const Material& material : material_library()) {
    Json entry = json_material(material);
    entry["group"] = group_of(material);
    json.push_back(std::move(entry));
  }
  return json;
}

Result<ExitCode> draw_sheet(const Session& session, const std::string& file) {
  if (const Result<void> checked = check_outputs({file}); !checked) {
    return tl::unexpected(checked.error());
  }
  ProgressBar progress(session, "drawing");
  const Result<Image> sheet = material_sheet(session.threads, progress.callback());
  progress.wipe();
  if (!sheet) {
    return tl::unexpected(sheet.error());
  }
  Rendering rendering;
  rendering.color = *sheet;
  if (const auto written = write_outputs({file}, rendering, {}); !written) {
    return tl::unexpected(written.error());
  }
  if (file != kStdout) {
    say(session, fmt::format("wrote {} ({} x {})", file, sheet->width, sheet->height));
  }
  return ExitCode::success;
}

Result<ExitCode> run_materials(const Session& session, const MaterialsFlags& flags) {
  if (!flags.sheet.empty()) {
    return draw_sheet(session, flags.sheet);
  }
  const Result<void> printed = session.json ? print_json(list_json()) : print(list_text());
  return printed.map([] { return ExitCode::success; });
}

}  // namespace

Command make_materials(CommandLine& line, Session& session) {
  CLI::App* app = add_subcommand(line, session, "materials", "Lists the library of classic materials");
  auto flags = std::make_shared<MaterialsFlags>();
  app->add_option("--sheet", flags->sheet, "Draws them all on spheres, with their names, in place of the list: .png, .exr or .pfm")
      ->type_name("FILE")
      ->group("Output");
  return {app,
          {{"lustro materials", "the 29 of them with their coefficients"}, {"lustro materials --sheet materials.png", "how they look"}},
          [&session, flags] { return run_materials(session, *flags); }};
}

}  // namespace lustro::app
