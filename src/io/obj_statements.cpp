// The table of OBJ statements (Wavefront, The Advanced Visualizer manual, appendix B1).
#include "io/obj_statements.hpp"

#include <algorithm>
#include <array>

namespace lustro {

namespace {

// What is known and left out, by what it says in the note.
struct SkippedStatement {
  std::string_view word;
  std::string_view note;
};
constexpr std::string_view kFreeForm = "curves and surfaces are skipped: only polygons are read";
constexpr std::string_view kDisplay = "statements of display and grouping (bevel, lod, mg, ...) are skipped";
constexpr std::array kSkipped{
    SkippedStatement{"p", "point elements (p) are skipped"},
    SkippedStatement{"l", "line elements (l) are skipped"},
    SkippedStatement{"vp", kFreeForm},
    SkippedStatement{"cstype", kFreeForm},
    SkippedStatement{"deg", kFreeForm},
    SkippedStatement{"bmat", kFreeForm},
    SkippedStatement{"step", kFreeForm},
    SkippedStatement{"curv", kFreeForm},
    SkippedStatement{"curv2", kFreeForm},
    SkippedStatement{"surf", kFreeForm},
    SkippedStatement{"parm", kFreeForm},
    SkippedStatement{"trim", kFreeForm},
    SkippedStatement{"hole", kFreeForm},
    SkippedStatement{"scrv", kFreeForm},
    SkippedStatement{"sp", kFreeForm},
    SkippedStatement{"end", kFreeForm},
    SkippedStatement{"con", kFreeForm},
    SkippedStatement{"bsp", kFreeForm},
    SkippedStatement{"bzp", kFreeForm},
    SkippedStatement{"cdc", kFreeForm},
    SkippedStatement{"cdp", kFreeForm},
    SkippedStatement{"res", kFreeForm},
    SkippedStatement{"bevel", kDisplay},
    SkippedStatement{"c_interp", kDisplay},
    SkippedStatement{"d_interp", kDisplay},
    SkippedStatement{"lod", kDisplay},
    SkippedStatement{"mg", kDisplay},
    SkippedStatement{"shadow_obj", kDisplay},
    SkippedStatement{"trace_obj", kDisplay},
    SkippedStatement{"ctech", kDisplay},
    SkippedStatement{"stech", kDisplay},
    SkippedStatement{"maplib", "texture maps by maplib and usemap are skipped"},
    SkippedStatement{"usemap", "texture maps by maplib and usemap are skipped"},
    SkippedStatement{"call", "calls of other files and of commands are skipped"},
    SkippedStatement{"csh", "calls of other files and of commands are skipped"},
};
constexpr std::array<std::string_view, 10> kRead{"v", "vt", "vn", "f", "fo", "o", "g", "s", "usemtl", "mtllib"};

}  // namespace

bool is_obj_statement(std::string_view word) {
  return std::find(kRead.begin(), kRead.end(), word) != kRead.end() || !note_of_skipped_obj_statement(word).empty();
}

std::string_view note_of_skipped_obj_statement(std::string_view word) {
  const auto* const known = std::find_if(kSkipped.begin(), kSkipped.end(), [&](const SkippedStatement& s) { return s.word == word; });
  return known != kSkipped.end() ? known->note : std::string_view();
}

}  // namespace lustro
