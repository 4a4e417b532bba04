// Counts what a test program allocates, by the language's own hooks: the only way to see reservations that are never touched. To be included by
// one source of a program; where LUSTRO_HOOKS_ARE_TAKEN is defined there is nothing to count with, and the tests that count are left out.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define LUSTRO_HOOKS_ARE_TAKEN  // the thread sanitizer brings its own
#endif
#endif
#ifndef LUSTRO_HOOKS_ARE_TAKEN

namespace lustro {
inline std::atomic<std::size_t> allocations{0};
inline std::atomic<std::size_t> allocated_bytes{0};
}  // namespace lustro

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"  // sees free() inside delete, but not malloc() inside new
#endif

void* operator new(std::size_t size) {
  ++lustro::allocations;
  lustro::allocated_bytes += size;
  void* memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) {
    throw std::bad_alloc();
  }
  return memory;
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

#endif
