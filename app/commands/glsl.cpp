// `lustro glsl`: the lighting equation as a pair of GLSL ES 3.00 shaders, on stdout or as PREFIX.vert and PREFIX.frag.
#include "shade/glsl.hpp"

#include <fmt/format.h>

#include <span>

#include "app/commands.hpp"
#include "app/json_out.hpp"
#include "app/words.hpp"
#include "lustro/image.hpp"
#include "scene/text_values.hpp"
#include "scene/words.hpp"

namespace lustro::app {
namespace {

struct GlslFlags {
  std::string lighting = "phong", interpolation = "phong", projection = "perspective", transfer = "srgb", stage = "both";
  std::string terms;
  bool two_sided = false, normalized = false, fog = false;
  int max_lights = 8;
  std::string prefix;
};

Result<GlslOptions> options_of(const GlslFlags& flags) {
  if (flags.max_lights < 1 || flags.max_lights > 256) {
    return fail(ErrorKind::usage, "--max-lights", fmt::format("{} is outside 1..256", flags.max_lights));
  }
  const Result<TermSet> terms = flags.terms.empty() ? Result<TermSet>(TermSet{}) : parse_terms(flags.terms);
  if (!terms) {
    return fail(terms.error().kind, "--terms", terms.error().message);
  }
  const GlslOptions defaults;  // the words are checked already
  return GlslOptions{.lighting = parse_word<Lighting>(flags.lighting).value_or(defaults.lighting),
                     .interpolation = parse_word<Interpolation>(flags.interpolation).value_or(defaults.interpolation),
                     .projection = parse_word<Projection>(flags.projection).value_or(defaults.projection),
                     .terms = *terms,
                     .two_sided = flags.two_sided,
                     .normalized = flags.normalized,
                     .fog = flags.fog,
                     .transfer = parse_word<Transfer>(flags.transfer).value_or(defaults.transfer),
                     .max_lights = flags.max_lights};
}

struct Shader {
  std::string stage, suffix, text;
};

Result<ExitCode> run_glsl(const Session& session, const GlslFlags& flags) {
  const Result<GlslOptions> options = options_of(flags);
  if (!options) {
    return tl::unexpected(options.error());
  }
  std::vector<Shader> shaders;
  if (flags.stage != "fragment") {
    shaders.push_back({"vertex", ".vert", glsl_shader(GlslStage::vertex, *options)});
  }
  if (flags.stage != "vertex") {
    shaders.push_back({"fragment", ".frag", glsl_shader(GlslStage::fragment, *options)});
  }
  if (!flags.prefix.empty()) {
    for (const Shader& shader : shaders) {
      if (const Result<void> written = write_file_atomically(flags.prefix + shader.suffix, std::as_bytes(std::span(shader.text))); !written) {
        return tl::unexpected(written.error());
      }
    }
    if (!session.json) {
      return ExitCode::success;
    }
  }
  if (session.json) {
    Json json;
    for (const Shader& shader : shaders) {
      json[shader.stage] = flags.prefix.empty() ? shader.text : flags.prefix + shader.suffix;
    }
    return print_json(json).map([] { return ExitCode::success; });
  }
  std::string text;
  for (const Shader& shader : shaders) {
    text += shaders.size() > 1 ? fmt::format("// ==== {} shader ====\n{}\n", shader.stage, shader.text) : shader.text;
  }
  return print(text).map([] { return ExitCode::success; });
}

}  // namespace

Command make_glsl(CommandLine& line, Session& session) {
  CLI::App* app = add_subcommand(line, session, "glsl", "Prints the lighting equation as GLSL ES 3.00 vertex and fragment shaders");
  auto flags = std::make_shared<GlslFlags>();
  const std::string shading = "Shading";
  one_of(app->add_option("--lighting", flags->lighting, "How a point is lit (default: phong)"), strings_of(words_of<Lighting>()))
      ->group(shading);
  one_of(app->add_option("--interpolation", flags->interpolation, "Where the equation is evaluated (default: phong)"),
         strings_of(words_of<Interpolation>()))
      ->group(shading);
  one_of(app->add_option("--projection", flags->projection, "Whether V differs from point to point (default: perspective)"),
         strings_of(words_of<Projection>()))
      ->group(shading);
  app->add_option("--terms", flags->terms, "The parts of the sum: some of ambient,diffuse,specular,emission, or none (default: all)")
      ->type_name("LIST")
      ->group(shading);
  app->add_flag("--two-sided", flags->two_sided, "Lights the back of a face with its normals turned round")->group(shading);
  app->add_flag("--normalized", flags->normalized, "Energy-normalised specular lobes, times N.L")->group(shading);
  app->add_flag("--fog", flags->fog, "Adds fog on the distance from the eye")->group(shading);
  one_of(app->add_option("--transfer", flags->transfer, "Whether the result is encoded as sRGB (default: srgb)"),
         strings_of(words_of<Transfer>()))
      ->group(shading);
  app->add_option("--max-lights", flags->max_lights, "The size of the array of lights, 1..256 (default: 8)")->type_name("N")->group(shading);
  const std::string output = "Output";
  one_of(app->add_option("--stage", flags->stage, "Which shader (default: both)"), {"vertex", "fragment", "both"})->group(output);
  app->add_option("-o,--output", flags->prefix, "Writes PREFIX.vert and PREFIX.frag instead of printing them")
      ->type_name("PREFIX")
      ->group(output);
  return {app,
          {{"lustro glsl --lighting blinn-phong -o blinn", "writes blinn.vert and blinn.frag"},
           {"lustro glsl --interpolation gouraud --stage vertex", "prints the shader that lights vertices"},
           {"lustro glsl --terms diffuse --stage fragment --transfer none", "prints Lambert's term alone, not encoded"}},
          [&session, flags] { return run_glsl(session, *flags); }};
}

}  // namespace lustro::app
