#include "plugin/cli/terminal/malloc_tuning.hpp"

#include <malloc.h>

#include <limits>

namespace pcvt::cli {
namespace {

/// The largest threshold that glibc accepts: larger blocks always return to the kernel.
constexpr int kLargestKept = 32 << 20;

}  // namespace

void keep_freed_memory() {
    mallopt(M_MMAP_THRESHOLD, kLargestKept);
    mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
    // With one heap all threads reuse the memory that one of them has freed.
    mallopt(M_ARENA_MAX, 1);
}

}  // namespace pcvt::cli
