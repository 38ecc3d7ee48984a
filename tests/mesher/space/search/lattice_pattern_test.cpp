#include "mesher/space/search/lattice_pattern.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "mesher/base/error.hpp"

namespace pcvt::space {
namespace {

const Eigen::Matrix3d kCube = Eigen::Matrix3d::Identity();

/// The lowest energies on the cube over the body-centred cubic lattice, computed independently of
/// this program to four digits.
TEST(BestSpacePattern, HasTheKnownEnergiesOnTheCube) {
    const std::pair<int, double> known[] = {
        {1, 1.0610}, {2, 1},       {3, 1.0626},  {4, 1.0026},  {5, 1.0942},
        {6, 1.0508}, {7, 1.0300},  {8, 1.0106},  {9, 1.0054},  {12, 1.0148},
        {16, 1},     {20, 1.0008}, {27, 1.0147}, {32, 1.0026},
    };
    for (const auto& [n, ratio] : known) {
        const LatticePattern pattern = best_lattice(kCube, n);
        EXPECT_NEAR(pattern.moment / kBodyCentredMoment, ratio, 5.5e-5) << n;
        EXPECT_EQ(pattern.n_sites(), n);
    }
}

TEST(BestSpacePattern, IsBodyCentredWhereThatFitsAndFaceCentredAtFour) {
    for (const int n : {2, 16, 54, 128}) {
        EXPECT_NEAR(best_lattice(kCube, n).moment / kBodyCentredMoment, 1, 1e-14) << n;
    }
    for (const int n : {4, 32}) {
        EXPECT_NEAR(best_lattice(kCube, n).moment, std::pow(2, -11.0 / 3), 1e-15) << n;
    }
}

TEST(LatticePattern, OfAGridIsSimpleCubic) {
    for (const int k : {1, 2, 3}) {
        const LatticePattern grid = lattice_pattern(kCube, {.a = k, .d = k, .f = k});
        EXPECT_NEAR(grid.moment, 1.0 / 12, 1e-15);
        // Each cube of side 1 / k has the second moment side^5 / 4.
        EXPECT_NEAR(grid.energy, 0.25 / (k * k), 1e-15);
    }
}

/// Law (1).
TEST(LatticePattern, BasisIsObtuseAndSpansThePeriodVectors) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> entry(-1, 1);
    for (int trial = 0; trial < 200; ++trial) {
        Eigen::Matrix3d period = Eigen::Matrix3d::NullaryExpr([&] { return entry(random); });
        period += 0.5 * kCube;
        if (trial % 4 == 0) period.col(1) *= 100;
        if (trial % 4 == 1) period.col(0) += 50 * period.col(1) - 20 * period.col(2);
        const int n = 1 + trial % 24;
        const LatticePattern pattern = best_lattice(period, n);
        const double cell = std::abs(period.determinant()) / n;
        EXPECT_NEAR(pattern.basis.determinant() / cell, 1, 1e-9);
        const Eigen::Matrix3d steps = pattern.basis.inverse() * period;
        const double largest = steps.cwiseAbs().maxCoeff();
        EXPECT_LT((steps - steps.array().round().matrix()).cwiseAbs().maxCoeff(), 1e-9 * largest);
        Eigen::Matrix<double, 3, 4> v;
        v << pattern.basis, -pattern.basis.rowwise().sum();
        const Eigen::Matrix4d dots = v.transpose() * v;
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j < i; ++j) EXPECT_LE(dots(i, j), 1e-10 * dots.diagonal().maxCoeff());
        }
        EXPECT_GE(pattern.moment, kBodyCentredMoment * (1 - 1e-14));
    }
}

/// All bases of the same periods give the same energy, which scales with the fifth power of length.
TEST(BestSpacePattern, DependsOnThePeriodLatticeAlone) {
    Eigen::Matrix3d period;
    period << 1, 0.2, -0.1, 0, 0.9, 0.3, 0, 0, 1.3;
    Eigen::Matrix3d change;
    change << 1, 4, -7, 0, -1, 3, 0, 0, 1;
    for (int n = 1; n <= 20; ++n) {
        const LatticePattern pattern = best_lattice(period, n);
        EXPECT_NEAR(best_lattice(period * change, n).moment / pattern.moment, 1, 1e-12);
        EXPECT_NEAR(best_lattice(period * 1e-40, n).energy / pattern.energy / 1e-200, 1, 1e-11);
    }
}

/// The sites of a form as sorted triples in n-ths of a period of the cube.
std::set<std::array<long, 3>> sites_of(const HermiteForm& form) {
    const Eigen::Matrix3Xd points = pattern_points(lattice_pattern(kCube, form));
    std::set<std::array<long, 3>> sites;
    const long n = form.index();
    for (const auto& p : points.colwise()) {
        std::array<long, 3> site{};
        for (int x = 0; x < 3; ++x) {
            const long step = std::lround(p[x] * double(n));
            EXPECT_NEAR(p[x] * double(n), double(step), 1e-9);
            site[x] = (step % n + n) % n;
        }
        sites.insert(site);
    }
    return sites;
}

/// There are as many lattices of index n as triples d, f, a = n / (d f) with weight d f^2; all
/// forms differ, and each is a group of n sites.
TEST(LatticePattern, FormsAreAllLatticesOnce) {
    const int counts[] = {1, 7, 13, 35, 31, 91, 57, 155};
    for (int n = 1; n <= 8; ++n) {
        std::set<std::set<std::array<long, 3>>> lattices;
        for (int a = 1; a <= n; ++a) {
            for (int d = 1; d <= n; ++d) {
                if (n % (a * d) != 0) continue;
                const int f = n / a / d;
                for (int k = 0; k < d * f * f; ++k) {
                    const HermiteForm form{a, d, f, k % d, k / d % f, k / d / f};
                    const auto sites = sites_of(form);
                    EXPECT_EQ(sites.size(), static_cast<std::size_t>(n));
                    for (const auto& s : sites) {
                        for (const auto& t : sites) {
                            EXPECT_TRUE(sites.contains(
                                {(s[0] + t[0]) % n, (s[1] + t[1]) % n, (s[2] + t[2]) % n}));
                        }
                    }
                    lattices.insert(sites);
                }
            }
        }
        EXPECT_EQ(lattices.size(), static_cast<std::size_t>(counts[n - 1])) << n;
    }
}

TEST(BestSpacePattern, IsTheLowestOfAllForms) {
    Eigen::Matrix3d period;
    period << 1, 0.3, 0.1, 0, 0.8, 0.2, 0, 0, 1.7;
    for (const int n : {6, 11, 12}) {
        const double best = best_lattice(period, n).moment;
        double lowest = 1;
        for (int a = 1; a <= n; ++a) {
            for (int d = 1; d <= n; ++d) {
                if (n % (a * d) != 0) continue;
                const int f = n / a / d;
                for (int k = 0; k < d * f * f; ++k) {
                    const HermiteForm form{a, d, f, k % d, k / d % f, k / d / f};
                    lowest = std::min(lowest, lattice_pattern(period, form).moment);
                }
            }
        }
        EXPECT_NEAR(best / lowest, 1, 1e-12) << n;
    }
}

TEST(BestSpacePattern, RefusesBadInput) {
    EXPECT_THROW(best_lattice(kCube, 0), InvalidInput);
    EXPECT_THROW(best_lattice(kCube, 1'000'000), LimitExceeded);
    EXPECT_THROW(best_lattice(Eigen::Matrix3d::Ones(), 2), InvalidInput);
    EXPECT_THROW(lattice_pattern(kCube, {.a = 1, .d = 2, .f = 1, .b = 2}), InvalidInput);
    EXPECT_THROW(lattice_pattern(kCube, {.a = 1, .d = 1, .f = 2, .c = 0, .e = -1}), InvalidInput);
}

}  // namespace
}  // namespace pcvt::space
