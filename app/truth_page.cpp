// The report of `lustro truth` as a page: figures as bars, and every pair of pictures with its difference.
#include <fmt/format.h>

#include <algorithm>

#include "report.hpp"
#include "truth_report.hpp"

namespace lustro::app {
namespace {

constexpr std::string_view kStyle = R"(
:root { color-scheme: light dark; --ink: #1c1c1f; --soft: #5d5d66; --paper: #fbfbfc; --line: #d9d9df; --bar: #9a5b13; --noise: #b9b9c2; }
@media (prefers-color-scheme: dark) { :root { --ink: #ececf0; --soft: #a3a3ad; --paper: #16161a; --line: #34343c; --bar: #e6a23c; --noise: #55555f; } }
body { margin: 2rem auto; max-width: 76rem; padding: 0 1rem; font: 1rem/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper); }
h1 { font-size: 1.5rem; } h2 { font-size: 1.15rem; margin: 2.5rem 0 .25rem; } p { margin: .25rem 0 .75rem; color: var(--soft); }
.wide { overflow-x: auto; } table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th, td { text-align: right; padding: .35rem .6rem; border-bottom: 1px solid var(--line); white-space: nowrap; }
th:first-child, td:first-child { text-align: left; } td.bar { width: 30%; } td small { color: var(--soft); }
.bar span { display: block; height: .7rem; background: var(--bar); border-radius: .2rem; }
.three { display: grid; grid-template-columns: repeat(auto-fit, minmax(16rem, 1fr)); gap: .75rem; }
figure { margin: 0; } figure img { width: 100%; height: auto; display: block; border-radius: .3rem; } figcaption { color: var(--soft); font-size: .9rem; }
a { color: inherit; })";

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : printable(text)) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string cell(double value, double noise, bool is_signed = false) {
  return fmt::format("<td>{} <small>\u00b1 {:.4f}</small></td>", is_signed ? fmt::format("{:+.4f}", value) : fmt::format("{:.4f}", value),
                     noise);
}

std::string figure(const std::string& file, const std::string& title, const std::string& about) {
  return fmt::format(R"(<figure><a href="{0}"><img src="{0}" alt="{2}: {1}" loading="lazy"></a><figcaption>{1}</figcaption></figure>)", file,
                     escaped(title), escaped(about));
}

}  // namespace

std::string truth_page(const std::string& scene_name, const ApproximationReport& report) {
  const std::vector<TruthRow> rows = truth_rows(report);
  double largest = 1e-9;
  for (const TruthRow& row : rows) {
    largest = std::max(largest, row.error.rmse);
  }
  std::string page = fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{0}: the local picture and the truth</title>\n<style>{1}\n</style>\n<h1>{0}: the local picture and the truth</h1>\n",
      escaped(scene_name), kStyle);
  page += fmt::format(
      "<p>{} \u00d7 {} pixels, {} paths a pixel, {} rays, {:.1f} s. After \u00b1 stands the noise of the truth, one standard error. RMSE is of "
      "linear light; luminance and bias are the mean |dY| and the mean dY over the truth\u2019s mean Y, and a bias above 0 says that the truth "
      "is brighter.</p>\n",
      report.local.width, report.local.height, report.samples, grouped(report.rays), report.seconds);
  page +=
      "<div "
      "class=\"wide\"><table><thead><tr><th>what</th><th>RMSE</th><th></th><th>FLIP</th><th>luminance</th><th>bias</th></tr></thead><tbody>\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const TruthRow& row = rows[i];
    page += fmt::format("<tr><td><a href=\"#row-{}\">{}</a></td>{}<td class=\"bar\"><span style=\"width:{:.1f}%\"></span></td>{}{}{}</tr>\n", i,
                        escaped(row.title), cell(row.error.rmse, row.noise.rmse), 100 * row.error.rmse / largest,
                        cell(row.error.flip, row.noise.flip), cell(row.error.luminance, row.noise.luminance),
                        cell(row.error.bias, row.noise.bias, true));
  }
  page += "</tbody></table></div>\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const TruthRow& row = rows[i];
    page += fmt::format("<h2 id=\"row-{}\">{}</h2>\n<p>{}</p>\n<div class=\"three\">{}{}{}</div>\n", i, escaped(row.title), escaped(row.text),
                        figure(row.before, row.before_title, row.title), figure(row.after, row.after_title, row.title),
                        figure(row.difference, "difference (FLIP: dark is equal, bright is far apart)", row.title));
  }
  return page + "</html>\n";
}

}  // namespace lustro::app
