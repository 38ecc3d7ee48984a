#include "mesher/base/scoped_blocks.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

namespace pcvt {
namespace {

/// A block that nobody frees; LeakSanitizer finds it unless its scope does.
void lose_block(std::size_t n_bytes) {
    std::memset(ScopedBlocks::allocate_block(n_bytes), 1, n_bytes);
}

TEST(ScopedBlocks, FreeLostBlocksAndNoOthers) {
    std::vector<int, ScopedAllocator<int>> outlives(100, 7);
    {
        const ScopedBlocks blocks;
        std::vector<double, ScopedAllocator<double>> numbers;
        for (int k = 0; k < 1000; ++k) numbers.push_back(k);
        lose_block(1);
        lose_block(4096);
        outlives.resize(50);
        EXPECT_EQ(numbers[999], 999);
    }
    EXPECT_EQ(outlives[49], 7);
}

TEST(ScopedBlocks, InnerScopesKeepTheBlocksOfOuterOnes) {
    const ScopedBlocks outer;
    lose_block(10);
    void* const kept = ScopedBlocks::allocate_block(10);
    {
        const ScopedBlocks inner;
        lose_block(20);
        void* const freed = ScopedBlocks::allocate_block(30);
        ScopedBlocks::free_block(freed);
    }
    std::memset(kept, 2, 10);
    ScopedBlocks::free_block(kept);
    lose_block(40);
}

}  // namespace
}  // namespace pcvt
