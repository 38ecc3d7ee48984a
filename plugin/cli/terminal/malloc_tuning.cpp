#include "plugin/cli/terminal/malloc_tuning.hpp"

#include <malloc.h>

#include <limits>

namespace pcvt::cli {
namespace {

/// The most that glibc takes: larger blocks are mapped apart and given back all the same.
constexpr int kLargestKept = 32 << 20;

}  // namespace

void keep_freed_memory() {
    mallopt(M_MMAP_THRESHOLD, kLargestKept);
    mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
    // One heap for all threads: what one of them has freed serves the others.
    mallopt(M_ARENA_MAX, 1);
}

}  // namespace pcvt::cli
