#include "io/voxels/zlib_blocks.hpp"

#include <gtest/gtest.h>

#include <random>

namespace pcvt {
namespace {

TEST(ZlibBlocks, ReturnTheBytes) {
    std::mt19937 random(1);
    for (const std::size_t size : {0, 1, 2, 1000, 100'000}) {
        std::string bytes(size, 'a');
        for (std::size_t k = 0; k < size; k += 1 + random() % 50) bytes[k] = char(random());
        std::string unpacked = "head";
        EXPECT_TRUE(zlib_decompress(zlib_compressed(bytes), size, unpacked));
        EXPECT_EQ(unpacked, "head" + bytes);
    }
}

TEST(ZlibBlocks, RefuseOtherSizesAndDamage) {
    const std::string bytes(500, 'b');
    const std::string packed = zlib_compressed(bytes);
    std::string unpacked;
    EXPECT_FALSE(zlib_decompress(packed, 499, unpacked));
    EXPECT_FALSE(zlib_decompress(packed, 501, unpacked));
    EXPECT_FALSE(zlib_decompress(packed + "x", 500, unpacked));
    EXPECT_FALSE(zlib_decompress(packed.substr(1), 500, unpacked));
    for (std::size_t k = 0; k < packed.size(); ++k) {
        std::string damaged = packed;
        damaged[k] = char(damaged[k] ^ 0x10);
        unpacked.clear();
        EXPECT_TRUE(!zlib_decompress(damaged, 500, unpacked) || unpacked == bytes) << k;
    }
}

}  // namespace
}  // namespace pcvt
