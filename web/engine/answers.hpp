// What the page is answered, as JSON: web/src/engine/types.ts says the same for TypeScript.
#pragma once

#include <cstdint>
#include <string>

#include "app/json_out.hpp"
#include "lustro/render.hpp"

namespace lustro::web {

using app::Json;

/// {"error": {"kind", "where", "message"}}
[[nodiscard]] std::string error_answer(const Error& error);

/// The document as text; what is not UTF-8 is replaced.
[[nodiscard]] std::string answer(const Json& json);

/// `usage`, `io`, ...
[[nodiscard]] std::string_view kind_word(ErrorKind kind);

/// Notes as sentences.
[[nodiscard]] Json note_list(const Notes& notes);

/// The table of options: OptionGroup[].
[[nodiscard]] Json option_groups();

/// The library's materials: [{name, table}].
[[nodiscard]] Json material_list();

/// A material as scene files state it.
[[nodiscard]] Json material_table(const Material& material);

/// ViewInfo, but for what it frames.
[[nodiscard]] Json view_answer(const Camera& camera, const ImageSettings& image);

/// LightInfo[].
[[nodiscard]] Json light_list(const std::vector<Light>& lights);

}  // namespace lustro::web
