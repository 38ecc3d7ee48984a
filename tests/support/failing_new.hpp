#pragma once

// Replaces the allocator of a program, so that a test can let allocations fail. A program includes
// it once, and has no other tests.

#include <cstdlib>
#include <new>

namespace pcvt::testing {

/// The allocations of this thread that still succeed; negative: all of them.
inline thread_local long allocations_left = -1;
/// Whether only one allocation fails, or all from then on.
inline thread_local bool fails_once = false;

/// Returns null where the allocation fails.
inline void* allocate_or_null(std::size_t size) {
    if (allocations_left == 0) {
        if (fails_once) allocations_left = -1;
        return nullptr;
    }
    if (allocations_left > 0) --allocations_left;
    return std::malloc(size == 0 ? 1 : size);
}

inline void* allocate(std::size_t size) {
    if (void* memory = allocate_or_null(size)) return memory;
    throw std::bad_alloc();
}

}  // namespace pcvt::testing

void* operator new(std::size_t size) { return pcvt::testing::allocate(size); }
void* operator new[](std::size_t size) { return pcvt::testing::allocate(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return pcvt::testing::allocate_or_null(size);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
    return pcvt::testing::allocate_or_null(size);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
