// What `lustro truth` says: for the terminal, for scripts, and as a page with pictures.
#pragma once

#include <string>
#include <vector>

#include "json_out.hpp"
#include "lustro/approximation.hpp"

namespace lustro::app {

/// Three pictures that are looked at together, by the names of their files.
struct TruthRow {
  std::string title;
  std::string text;
  std::string before, before_title;
  std::string after, after_title;
  std::string difference;
  PictureError error, noise;
};

/// The report's rows: the whole, then causes that apply, then terms. File names follow from cause and term.
[[nodiscard]] std::vector<TruthRow> truth_rows(const ApproximationReport& report);

[[nodiscard]] std::string truth_text(const ApproximationReport& report);
[[nodiscard]] Json truth_json(const std::string& scene_name, const ApproximationReport& report);
/// One HTML page that shows the pictures beside it; asks no other host for anything.
[[nodiscard]] std::string truth_page(const std::string& scene_name, const ApproximationReport& report);

}  // namespace lustro::app
