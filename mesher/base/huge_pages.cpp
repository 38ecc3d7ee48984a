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
    // MADV_HUGEPAGE affects pages that are written later, MADV_COLLAPSE (Linux 6.1) the pages that
    // exist already. The kernel may refuse both.
    madvise(begin, n_bytes, MADV_HUGEPAGE);
    madvise(begin, n_bytes, MADV_COLLAPSE);
}
#else
void advise(void* /*begin*/, std::size_t /*n_bytes*/) {}
#endif

constexpr std::size_t kHugePage = std::size_t{1} << 21;

}  // namespace

void prefer_huge_pages(const void* begin, std::size_t n_bytes) {
    // madvise(2) takes a pointer to mutable memory, although advice does not change the contents.
    void* first = const_cast<void*>(begin);
    if (std::align(kHugePage, kHugePage, first, n_bytes) == nullptr) return;
    advise(first, n_bytes / kHugePage * kHugePage);
}

}  // namespace pcvt
