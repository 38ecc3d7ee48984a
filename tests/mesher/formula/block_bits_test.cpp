#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "mesher/formula/block_angles.hpp"
#include "mesher/formula/block_exponentials.hpp"
#include "mesher/formula/block_hyperbolics.hpp"
#include "mesher/formula/number_parts.hpp"

namespace pcvt {
namespace {

constexpr std::size_t kNumbers = 200;

constexpr BlockFunction* kAll[] = {block_exp,   block_log,   block_log2, block_log10, block_sqrt,
                                   block_cbrt,  block_sinh,  block_cosh, block_tanh,  block_asinh,
                                   block_acosh, block_atanh, block_sin,  block_cos,   block_tan,
                                   block_asin,  block_acos,  block_atan};

TEST(BlockFunctions, NumbersOfABlockDoNotDependOnEachOther) {
    std::mt19937_64 random(3);
    std::vector<double> x(kNumbers);
    for (std::size_t k = 0; k < x.size(); ++k) {
        x[k] = k % 3 == 0 ? from_bits(random()) : static_cast<double>(random() >> 11) * 0x1p-50 - 4;
    }
    for (BlockFunction* const f : kAll) {
        for (const int n : {1, 7, 64, 65, 199, 200}) {
            std::vector<double> y(kNumbers, -1);
            f(x.data(), y.data(), n);
            for (int k = 0; k < n; ++k) {
                ASSERT_EQ(bits_of(y[k]), bits_of(one_of_block(f, x[k]))) << x[k];
            }
        }
    }
}

TEST(BlockFunctions, HaveTheSameBitsOnEveryMachine) {
    // NaN have bits of their own and are left out.
    std::uint64_t hash = 14695981039346656037u;
    const auto add = [&](double y) {
        if (std::isnan(y)) return;
        hash = (hash ^ bits_of(y)) * 1099511628211u;
        hash ^= hash >> 29;
    };
    std::mt19937_64 random(5);
    for (int k = 0; k < 20'000; ++k) {
        const double near = static_cast<double>(random() >> 11) * 0x1p-51 - 2;
        const double any = from_bits(random());
        for (BlockFunction* const f : kAll) {
            add(one_of_block(f, near));
            add(one_of_block(f, 32 * near));
            add(one_of_block(f, any));
        }
        add(one_of_block(block_pow, std::abs(near), any));
        add(one_of_block(block_pow, 32 * std::abs(near), near));
        add(one_of_block(block_atan2, near, any));
    }
    EXPECT_EQ(hash, 11769249278961915923u);
}

}  // namespace
}  // namespace pcvt
