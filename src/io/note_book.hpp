// Notes of one file while it is read: each kind once, with the place where it was seen first and how often it was seen.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lustro/result.hpp"

namespace lustro {

/// Gathers notes in bounded memory: hostile input cannot make more than kMostKinds of them.
class NoteBook {
 public:
  static constexpr std::size_t kMostKinds = 100;

  explicit NoteBook(std::string file) : file_(std::move(file)) {}

  /// One more of the kind that `message` names, at a line (0: the file as a whole).
  void add(std::size_t line, std::string_view message, std::size_t count = 1);

  /// The notes in the order in which they were first seen, `(3 times)` behind what was seen more often.
  [[nodiscard]] Notes notes() const;

 private:
  struct Entry {
    std::size_t line;
    std::size_t count;
    std::string message;
  };
  std::string file_;
  std::vector<Entry> entries_;
  std::map<std::string, std::size_t, std::less<>> index_;  // message to entry
  std::size_t unlisted_ = 0;
};

}  // namespace lustro
