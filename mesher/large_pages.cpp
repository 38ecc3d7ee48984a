#include "mesher/large_pages.hpp"

#include <cstdint>

#if defined(__linux__)
#include <asm/mman.h>
#include <sys/mman.h>
#endif

namespace pcvt {
namespace {

#if defined(__linux__) && defined(MADV_HUGEPAGE) && defined(MADV_COLLAPSE)
void advise(void* begin, std::size_t n_bytes) {
    // The first is for what is not written yet, the second for what is (since Linux 6.1). Both may
    // be refused.
    madvise(begin, n_bytes, MADV_HUGEPAGE);
    madvise(begin, n_bytes, MADV_COLLAPSE);
}
#else
void advise(void* /*begin*/, std::size_t /*n_bytes*/) {}
#endif

constexpr std::uintptr_t kLargePage = std::uintptr_t{1} << 21;

}  // namespace

void prefer_large_pages(const void* begin, std::size_t n_bytes) {
    const auto address = reinterpret_cast<std::uintptr_t>(begin);
    const std::uintptr_t first = (address + kLargePage - 1) / kLargePage * kLargePage;
    const std::uintptr_t end = (address + n_bytes) / kLargePage * kLargePage;
    if (first < end) advise(reinterpret_cast<void*>(first), end - first);
}

}  // namespace pcvt
