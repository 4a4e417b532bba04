// Counting notes by kind.
#include "io/note_book.hpp"

#include <fmt/format.h>

#include <utility>

#include "io/text.hpp"

namespace lustro {

void NoteBook::add(std::size_t line, std::string_view message, std::size_t count) {
  if (const auto known = index_.find(message); known != index_.end()) {
    entries_[known->second].count += count;
  } else if (entries_.size() < kMostKinds) {
    index_.emplace(message, entries_.size());
    entries_.push_back({line, count, std::string(message)});
  } else {
    unlisted_ += count;
  }
}

Notes NoteBook::notes() const {
  Notes notes;
  notes.reserve(entries_.size() + 1);
  for (const Entry& entry : entries_) {
    std::string message = entry.count > 1 ? fmt::format("{} ({} times)", entry.message, entry.count) : entry.message;
    notes.push_back({entry.line != 0 ? at_line(file_, entry.line) : file_, std::move(message)});
  }
  if (unlisted_ != 0) {
    notes.push_back({file_, fmt::format("{} more notes of other kinds are not listed", unlisted_)});
  }
  return notes;
}

}  // namespace lustro
