#pragma once

#include <cstddef>
#include <new>

namespace pcvt {

/// Frees the blocks that ScopedAllocator allocated in this thread since its construction and that
/// nobody has freed: a container of a library may lose a block where its memory runs out.
///
/// Example usage:
///     struct Triangulator {
///         ScopedBlocks blocks;        // is destroyed after the triangulation
///         Triangulation triangulation;
///     };
class ScopedBlocks {
   public:
    ScopedBlocks() : before_(current()) { current() = this; }
    ScopedBlocks(const ScopedBlocks&) = delete;
    ScopedBlocks& operator=(const ScopedBlocks&) = delete;
    ~ScopedBlocks() {
        while (head_.next != &head_) free_block(head_.next + 1);
        current() = before_;
    }

    /// A block that the current scope frees, if there is one.
    static void* allocate_block(std::size_t n_bytes) {
        auto* const block = static_cast<Link*>(::operator new(sizeof(Link) + n_bytes));
        Link* const head = current() != nullptr ? &current()->head_ : nullptr;
        block->before = head != nullptr ? head : block;
        block->next = head != nullptr ? head->next : block;
        block->before->next = block->next->before = block;
        return block + 1;
    }
    static void free_block(void* memory) {
        Link* const block = static_cast<Link*>(memory) - 1;
        block->before->next = block->next;
        block->next->before = block->before;
        ::operator delete(block);
    }

   private:
    /// Stands before each block, in a ring.
    struct alignas(std::max_align_t) Link {
        Link* before;
        Link* next;
    };

    static ScopedBlocks*& current() {
        thread_local ScopedBlocks* scope = nullptr;
        return scope;
    }

    Link head_{&head_, &head_};
    ScopedBlocks* before_;
};

/// Allocates blocks that the current ScopedBlocks frees at the latest.
template <class T>
struct ScopedAllocator {
    using value_type = T;

    ScopedAllocator() = default;
    template <class Other>
    ScopedAllocator(const ScopedAllocator<Other>& /*other*/) {}

    T* allocate(std::size_t n) {
        static_assert(alignof(T) <= alignof(std::max_align_t));
        return static_cast<T*>(ScopedBlocks::allocate_block(n * sizeof(T)));
    }
    void deallocate(T* memory, std::size_t /*n*/) { ScopedBlocks::free_block(memory); }

    friend bool operator==(const ScopedAllocator& /*a*/, const ScopedAllocator& /*b*/) {
        return true;
    }
};

}  // namespace pcvt
