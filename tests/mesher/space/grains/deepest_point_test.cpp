#include "mesher/space/grains/deepest_point.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <limits>

#include "tests/support/random_numbers.hpp"

namespace pcvt::space {
namespace {

double depth(const std::vector<HalfSpace>& half_spaces, const Vec3& x) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [normal, height] : half_spaces) {
        least = std::min(least, height - normal.dot(x));
    }
    return least;
}

/// The largest least depth, from all points that are as deep in four half-spaces.
double depth_of_four(const std::vector<HalfSpace>& half_spaces) {
    double deepest = -std::numeric_limits<double>::infinity();
    const int n = static_cast<int>(half_spaces.size());
    for (int a = 0; a < n; ++a) {
        for (int b = 0; b < a; ++b) {
            for (int c = 0; c < b; ++c) {
                for (int d = 0; d < c; ++d) {
                    Eigen::Matrix4d rows;
                    Eigen::Vector4d heights;
                    int k = 0;
                    for (const int h : {a, b, c, d}) {
                        rows.row(k) << half_spaces[h].normal.transpose(), 1;
                        heights[k++] = half_spaces[h].height;
                    }
                    const Eigen::Vector4d x = rows.fullPivLu().solve(heights);
                    const double here = depth(half_spaces, x.head<3>());
                    if (here > x[3] - 1e-9) deepest = std::max(deepest, here);
                }
            }
        }
    }
    return deepest;
}

/// Half-spaces round a thin plate, and others round the origin, some of which may leave nothing.
std::vector<HalfSpace> random_half_spaces(std::mt19937_64& random, double thickness) {
    std::vector<HalfSpace> all;
    for (int k = 0; k < 8; ++k) {
        const auto number = [&] { return testing::random_number(random) - 0.5; };
        const Vec3 normal = Vec3(number(), number(), number()).normalized();
        all.push_back({normal, 0.4 + 0.5 * number()});
    }
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
        all.push_back({axis, 1});
        all.push_back({-axis, 1});
    }
    const Vec3 up = Vec3(1, 2, 3).normalized();
    all.push_back({up, 0.1});
    all.push_back({(-up + Vec3(0, 0, 1e-4)).normalized(), thickness - 0.1});
    return all;
}

TEST(DeepestPoint, IsNoLessDeepThanAnyOther) {
    std::mt19937_64 random(7);
    int n_outside = 0;
    for (const double thickness : {1.0, 1e-3, 1e-6, -1e-3}) {
        for (int run = 0; run < 4; ++run) {
            const std::vector<HalfSpace> all = random_half_spaces(random, thickness);
            const double expected = depth_of_four(all);
            EXPECT_NEAR(depth(all, deepest_point(all, Vec3(0.1, 0, 0), 8)), expected, 1e-11);
            n_outside += expected < 0 ? 1 : 0;
        }
    }
    EXPECT_GE(n_outside, 4);
}

}  // namespace
}  // namespace pcvt::space
