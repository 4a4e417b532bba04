// The report of `lustro truth` as text and as JSON: see truth_report.hpp.
#include "truth_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report.hpp"

namespace lustro::app {
namespace {

std::string_view term_name(AovKind term) {
  return aov_names()[static_cast<std::size_t>(term)];
}

std::string_view term_text(AovKind term) {
  return term == AovKind::ambient ? "the ambient term beside all light that met more than one surface"
                                  : "the term beside its own direct light, with shadows";
}

Json error_json(const PictureError& e) {
  return {{"rmse", json_number(e.rmse)}, {"flip", json_number(e.flip)}, {"luminance", json_number(e.luminance)}, {"bias", json_number(e.bias)}};
}

/// A figure and its noise: 0.0123 +- 0.0004.
std::string figure(double value, double noise, bool is_signed = false) {
  const std::string number = is_signed ? fmt::format("{:+.4f}", value) : fmt::format("{:.4f}", value);
  return fmt::format("{:>8} \u00b1 {:.4f}", number, noise);
}

std::string line(std::string_view name, const PictureError& error, const PictureError& noise) {
  return fmt::format("{:<16} {}   {}   {}   {}\n", name, figure(error.rmse, noise.rmse), figure(error.flip, noise.flip),
                     figure(error.luminance, noise.luminance), figure(error.bias, noise.bias, true));
}

}  // namespace

std::vector<TruthRow> truth_rows(const ApproximationReport& report) {
  std::vector<TruthRow> rows;
  rows.push_back({"local and true", "the picture as the local model draws it, and the truth", "local.png", "local", "truth.png", "truth",
                  "difference.png", report.error, report.noise});
  for (const CauseError& cause : report.causes) {
    if (cause.applies) {
      const std::string name(cause_name(cause.cause));
      rows.push_back({name, std::string(cause_text(cause.cause)), fmt::format("cause-{}-with.png", name), "with it",
                      fmt::format("cause-{}-without.png", name), "without it", fmt::format("cause-{}-difference.png", name), cause.error,
                      cause.noise});
    }
  }
  for (const TermError& term : report.terms) {
    const std::string name(term_name(term.term));
    rows.push_back({name + " term", std::string(term_text(term.term)), fmt::format("term-{}-local.png", name), "local",
                    fmt::format("term-{}-truth.png", name), "truth", fmt::format("term-{}-difference.png", name), term.error, term.noise});
  }
  return rows;
}

std::string truth_text(const ApproximationReport& report) {
  std::string text = fmt::format("{:<16} {:<17}   {:<17}   {:<17}   {}\n", "", "RMSE", "FLIP", "luminance", "bias");
  text += line("local and true", report.error, report.noise);
  text += "\nby cause\n";
  for (const CauseError& cause : report.causes) {
    text += cause.applies ? line(cause_name(cause.cause), cause.error, cause.noise)
                          : fmt::format("{:<16} the scene does not have it\n", cause_name(cause.cause));
  }
  text += "\nby term\n";
  for (const TermError& term : report.terms) {
    text += line(term_name(term.term), term.error, term.noise);
  }
  text += fmt::format("\n{} paths a pixel, {} rays, {:.1f} s; after \u00b1: the noise of the truth, one standard error\n", report.samples,
                      grouped(report.rays), report.seconds);
  text += "RMSE: linear light. luminance, bias: mean |dY| and mean dY over the truth's mean Y; bias above 0: the truth is brighter\n";
  return text;
}

Json truth_json(const std::string& scene_name, const ApproximationReport& report) {
  Json causes = Json::array(), terms = Json::array();
  for (const CauseError& cause : report.causes) {
    Json entry{{"cause", cause_name(cause.cause)}, {"text", cause_text(cause.cause)}, {"applies", cause.applies}};
    if (cause.applies) {
      entry["error"] = error_json(cause.error);
      entry["noise"] = error_json(cause.noise);
    }
    causes.push_back(std::move(entry));
  }
  for (const TermError& term : report.terms) {
    terms.push_back({{"term", term_name(term.term)}, {"error", error_json(term.error)}, {"noise", error_json(term.noise)}});
  }
  return {{"scene", scene_name},
          {"width", report.local.width},
          {"height", report.local.height},
          {"samples", report.samples},
          {"rays", report.rays},
          {"seconds", json_number(report.seconds)},
          {"error", error_json(report.error)},
          {"noise", error_json(report.noise)},
          {"causes", std::move(causes)},
          {"terms", std::move(terms)},
          {"notes", json_notes(report.notes)}};
}

}  // namespace lustro::app
