// madvise() on the whole huge pages within a block.
#include "parallel/big_memory.hpp"

#ifdef __linux__
#include <sys/mman.h>

#include <cstdint>
#endif

namespace lustro {

void prefer_huge_pages([[maybe_unused]] void* data, [[maybe_unused]] std::size_t bytes) {
#ifdef __linux__
  constexpr std::uintptr_t kHugePage = std::uintptr_t{1} << 21U;
  constexpr std::uintptr_t kPage = 4096;
  const auto address = reinterpret_cast<std::uintptr_t>(data);
  const std::uintptr_t skipped = (kPage - address % kPage) % kPage;
  if (bytes >= skipped + 2 * kHugePage) {
    (void)::madvise(static_cast<char*>(data) + skipped, (bytes - skipped) / kPage * kPage, MADV_HUGEPAGE);
  }
#endif
}

}  // namespace lustro
