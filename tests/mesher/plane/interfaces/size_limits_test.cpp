#include "mesher/plane/interfaces/size_limits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pcvt::plane {
namespace {

TEST(SizeLimits, AreThoseOfALoopOverAll) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (const int n : {0, 1, 8, 9, 500}) {
        std::vector<SizeLimit> list;
        for (int k = 0; k < n; ++k) {
            const double x = uniform(random);
            list.push_back({{x, uniform(random)}, 0.01 * std::pow(10.0, 2 * uniform(random))});
        }
        const SizeLimits limits(list);
        for (int k = 0; k < 200; ++k) {
            const double x = 2 * uniform(random);
            const Vec2 p(x, uniform(random));
            EXPECT_EQ(limits.at(p), size_at(list, p));
        }
    }
}

}  // namespace
}  // namespace pcvt::plane
