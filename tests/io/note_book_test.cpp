// Notes by kind.
#include "io/note_book.hpp"

#include <gtest/gtest.h>

#include <string>

namespace lustro {
namespace {

TEST(NoteBook, EachKindIsSaidOnceWithItsFirstPlaceAndItsCount) {
  NoteBook book("a.obj");
  book.add(3, "lines are skipped");
  book.add(9, "points are skipped");
  book.add(12, "lines are skipped");
  book.add(0, "colours are clamped", 5);
  const Notes expected{
      {"a.obj:3", "lines are skipped (2 times)"}, {"a.obj:9", "points are skipped"}, {"a.obj", "colours are clamped (5 times)"}};
  EXPECT_EQ(book.notes(), expected);
}

TEST(NoteBook, KindsWithoutEndTakeNoMemory) {
  NoteBook book("a.obj");
  for (std::size_t i = 0; i < 100000; ++i) {
    book.add(1, "unknown " + std::to_string(i));
  }
  const Notes notes = book.notes();
  ASSERT_EQ(notes.size(), NoteBook::kMostKinds + 1);
  EXPECT_EQ(notes.back().message, "99900 more notes of other kinds are not listed");
}

}  // namespace
}  // namespace lustro
