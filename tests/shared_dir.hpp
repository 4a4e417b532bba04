// Where the shared test assets lie, and the words with which a test skips without them.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>

namespace lustro {

inline std::filesystem::path shared_dir() {
  return LUSTRO_SHARED_DIR;
}
inline bool has_shared_dir() {
  return std::filesystem::exists(shared_dir() / "assets" / "README.md");
}

}  // namespace lustro

#define LUSTRO_REQUIRE_SHARED()                                                                \
  if (!::lustro::has_shared_dir()) {                                                           \
    GTEST_SKIP() << "needs the shared test assets, and " << LUSTRO_SHARED_DIR << " is absent"; \
  }
