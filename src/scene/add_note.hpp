// Notes, each once.
#pragma once

#include <algorithm>
#include <utility>

#include "lustro/result.hpp"

namespace lustro {

/// Adds a note that is not there yet: however many objects share a material, what is said of it is said once.
inline void add_note(Notes& notes, Note note) {
  if (std::find(notes.begin(), notes.end(), note) == notes.end()) {
    notes.push_back(std::move(note));
  }
}

}  // namespace lustro
