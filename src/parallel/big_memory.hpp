// Memory for big arrays, in huge pages where the system has them: a fault for every 4 KiB costs more than what most loops do with the 4 KiB.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>
#include <vector>

namespace lustro {

/// Asks for huge pages within the memory at `data`, before it is touched. A hint: nothing depends on it.
void prefer_huge_pages(void* data, std::size_t bytes);

/// Room for `size` elements, as vector::reserve() makes it, in huge pages.
template <class T>
void reserve_big(std::vector<T>& list, std::size_t size) {
  if (size > list.capacity()) {
    list.reserve(size);
    prefer_huge_pages(list.data(), list.capacity() * sizeof(T));
  }
}

/// vector::resize() in huge pages.
template <class T>
void resize_big(std::vector<T>& list, std::size_t size) {
  reserve_big(list, size);
  list.resize(size);
}

struct FreeMemory {
  void operator()(void* memory) const { std::free(memory); }
};

/// An array whose elements begin with all bits 0; pages that are never touched cost nothing.
template <class T>
using BigArray = std::unique_ptr<T[], FreeMemory>;

template <class T>
[[nodiscard]] BigArray<T> make_big_array(std::size_t size) {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);
  void* const memory = std::calloc(size == 0 ? 1 : size, sizeof(T));
  if (memory == nullptr) {
    throw std::bad_alloc();
  }
  prefer_huge_pages(memory, size * sizeof(T));
  return BigArray<T>(static_cast<T*>(memory));
}

}  // namespace lustro
