// `lustro compare A B`: how two pictures differ, for people and for scripts.
#include <fmt/format.h>

#include <cmath>

#include "app/commands.hpp"
#include "app/json_out.hpp"
#include "app/words.hpp"
#include "lustro/image.hpp"
#include "scene/words.hpp"

namespace lustro::app {
namespace {

struct CompareFlags {
  std::string a, b;
  double tolerance = 2;  ///< in steps of 1/255
  double max_share = 0;  ///< percent of the pixels
  std::string transfer = "srgb";
  std::string heatmap;
};

bool is_same(const CompareFlags& flags, const Comparison& c) {
  return c.share_over * 100 <= flags.max_share;
}

Json compare_json(const CompareFlags& flags, const Comparison& c) {
  Json json{{"a", flags.a},
            {"b", flags.b},
            {"width", c.heatmap.width},
            {"height", c.heatmap.height},
            {"equal", c.max == 0},
            {"max", c.max},
            {"mean", c.mean},
            {"rmse", c.rmse},
            {"psnr", json_number(c.psnr)},  // null: infinite
            {"flip", c.flip},
            {"tolerance", flags.tolerance},
            {"share_over", c.share_over},
            {"max_share", flags.max_share / 100},
            {"within_tolerance", is_same(flags, c)}};
  return json;
}

std::string compare_text(const CompareFlags& flags, const Comparison& c) {
  std::string text;
  const auto in_steps = [](double x) { return fmt::format("{:.6f}   {:8.3f} / 255", x, x * 255); };
  text += fmt::format("max        {}\n", in_steps(c.max));
  text += fmt::format("mean       {}\n", in_steps(c.mean));
  text += fmt::format("RMSE       {}\n", in_steps(c.rmse));
  text += std::isfinite(c.psnr) ? fmt::format("PSNR       {:.2f} dB\n", c.psnr) : std::string("PSNR       infinite\n");
  text += fmt::format("FLIP       {:.6f}\n", c.flip);
  text += fmt::format("over {:<5} {:.4f} % of the pixels (allowed: {} %)\n", fmt::format("{}", flags.tolerance), c.share_over * 100,
                      flags.max_share);
  return text + (c.max == 0          ? "the pictures are equal\n"
                 : is_same(flags, c) ? "the pictures agree within the tolerance\n"
                                     : "the pictures differ\n");
}

Result<ExitCode> run_compare(const Session& session, const CompareFlags& flags) {
  if (!(flags.tolerance >= 0 && flags.tolerance <= 255)) {
    return fail(ErrorKind::usage, "--tolerance", fmt::format("{} is outside 0..255", flags.tolerance));
  }
  if (!(flags.max_share >= 0 && flags.max_share <= 100)) {
    return fail(ErrorKind::usage, "--max-share", fmt::format("{} is outside 0..100", flags.max_share));
  }
  const Transfer transfer = parse_word<Transfer>(flags.transfer).value_or(Transfer::srgb);
  const Result<Image> a = read_image(flags.a, transfer);
  if (!a) {
    return tl::unexpected(a.error());
  }
  const Result<Image> b = read_image(flags.b, transfer);
  if (!b) {
    return tl::unexpected(b.error());
  }
  if (a->width != b->width || a->height != b->height) {
    return fail(ErrorKind::usage, "",
                fmt::format("the sizes differ: {} has {} x {} pixels, {} {} x {}", flags.a, a->width, a->height, flags.b, b->width, b->height));
  }
  const Result<Comparison> comparison = compare_images(*a, *b, flags.tolerance / 255, transfer);
  if (!comparison) {
    return tl::unexpected(comparison.error());
  }
  if (!flags.heatmap.empty()) {
    if (const Result<void> written = write_image(flags.heatmap, comparison->heatmap); !written) {
      return tl::unexpected(written.error());
    }
  }
  const Result<void> printed = session.json    ? print_json(compare_json(flags, *comparison))
                               : session.quiet ? Result<void>{}
                                               : print(compare_text(flags, *comparison));
  if (!printed) {
    return tl::unexpected(printed.error());
  }
  return is_same(flags, *comparison) ? ExitCode::success : ExitCode::different;
}

}  // namespace

Command make_compare(CommandLine& line, Session& session) {
  CLI::App* app = add_subcommand(line, session, "compare", "Measures how two pictures (PNG, EXR, PFM) differ; the exit code is 1 where they do");
  auto flags = std::make_shared<CompareFlags>();
  app->add_option("A", flags->a, "A picture")->type_name("FILE")->required();
  app->add_option("B", flags->b, "The picture to compare with it, of the same size")->type_name("FILE")->required();
  const std::string group = "Comparison";
  app->add_option("--tolerance", flags->tolerance,
                  "A pixel counts where a channel differs by more than this, in steps of 1/255, 0..255 (default: 2)")
      ->type_name("STEPS")
      ->group(group);
  app->add_option("--max-share", flags->max_share, "Percent of the pixels that may do so, 0..100 (default: 0)")
      ->type_name("PERCENT")
      ->group(group);
  one_of(app->add_option("--transfer", flags->transfer, "How stored values become light and back (default: srgb)"), {"none", "srgb"})
      ->group(group);
  app->add_option("--heatmap", flags->heatmap, "Writes a picture of the differences as FLIP sees them: .png, .exr or .pfm")
      ->type_name("FILE")
      ->group("Output");
  return {app,
          {{"lustro compare golden.png new.png", "tells the differences"},
           {"lustro compare --tolerance 0 a.png b.png -q || echo different", "asks for equal bytes, quietly"},
           {"lustro compare a.png b.png --max-share 0.3 --heatmap where.png", "allows 3 pixels in 1000 and shows where they are"}},
          [&session, flags] { return run_compare(session, *flags); }};
}

}  // namespace lustro::app
