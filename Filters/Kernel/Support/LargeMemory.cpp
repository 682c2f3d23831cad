#include "Support/LargeMemory.h"

#ifdef __linux__
#include <cstdint>
#include <sys/mman.h>
#endif

namespace ransmesh
{
#ifdef __linux__
void preferLargePages(void* begin, std::size_t bytes)
{
  constexpr std::uintptr_t page = std::uintptr_t{ 1 } << 21;
  const auto address = reinterpret_cast<std::uintptr_t>(begin);
  const std::uintptr_t first = (address + page - 1) & ~(page - 1);
  const std::uintptr_t last = (address + bytes) & ~(page - 1);
  if (first < last)
  {
    // Without large pages the memory serves as well.
    static_cast<void>(madvise(static_cast<char*>(begin) + (first - address), last - first, MADV_HUGEPAGE));
  }
}
#else
void preferLargePages(void*, std::size_t) {}
#endif
} // namespace ransmesh
