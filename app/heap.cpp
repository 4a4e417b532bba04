// glibc's heap grows page by page, gives big blocks back at once, and has one arena a thread; this grows it once: see heap.hpp.
#include "heap.hpp"

#include <cstddef>
#include <cstdlib>

#include "parallel/big_memory.hpp"

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace lustro::app {

void prepare_heap() {
#if defined(__GLIBC__) && defined(NDEBUG)  // sanitizers bring their own heap, which would touch all of it
  ::mallopt(M_ARENA_MAX, 1);
  ::mallopt(M_MMAP_MAX, 0);  // no blocks outside the heap, which would be new to the system each time
  ::mallopt(M_TRIM_THRESHOLD, -1);
  constexpr std::size_t kMost = std::size_t{512} << 20U;  // of addresses: nothing is touched
  constexpr std::size_t kLeast = std::size_t{32} << 20U;
  for (std::size_t bytes = kMost; bytes >= kLeast; bytes /= 2) {  // less where the user has set limits
    if (void* const block = std::malloc(bytes); block != nullptr) {
      prefer_huge_pages(block, bytes);
      std::free(block);
      return;
    }
  }
#endif
}

void give_back_heap() {
#if defined(__GLIBC__)
  ::malloc_trim(0);
#endif
}

}  // namespace lustro::app
