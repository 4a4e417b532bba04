// The table of keys of docs/using/scene-file.md.
#pragma once

#include <string>

namespace lustro {

/// Markdown: a table a group of keys, and the words with what they mean. A test checks that the page on disk has it.
[[nodiscard]] std::string key_tables_markdown();

}  // namespace lustro
