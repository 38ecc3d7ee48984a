#include "mesher/base/huge_pages.hpp"

#include <memory>

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

constexpr std::size_t kHugePage = std::size_t{1} << 21;

}  // namespace

void prefer_huge_pages(const void* begin, std::size_t n_bytes) {
    // Advice leaves the memory as it is, and yet madvise(2) takes a pointer to what may change.
    void* first = const_cast<void*>(begin);
    if (std::align(kHugePage, kHugePage, first, n_bytes) == nullptr) return;
    advise(first, n_bytes / kHugePage * kHugePage);
}

}  // namespace pcvt
