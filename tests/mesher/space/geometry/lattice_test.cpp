#include "mesher/space/geometry/lattice.hpp"

#include <gtest/gtest.h>

#include "mesher/base/error.hpp"
#include "tests/support/space_lattices.hpp"

namespace pcvt::space {
namespace {

using testing::random_space_lattice;
using testing::space_lattices;

std::vector<testing::NamedSpaceLattice> lattices_and_random_ones() {
    auto all = space_lattices();
    std::mt19937_64 random(1);
    for (int k = 0; k < 200; ++k) all.push_back({std::to_string(k), random_space_lattice(random)});
    return all;
}

TEST(Lattice, CoordinatesAreInverse) {  // law 1
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> uniform(-3, 3);
    for (const auto& [name, lattice] : lattices_and_random_ones()) {
        SCOPED_TRACE(name);
        const double u = uniform(random);
        const double v = uniform(random);
        const Vec3 at(u, v, uniform(random));
        const double stretch = lattice.a().norm() * lattice.b().norm() * lattice.c().norm();
        EXPECT_LT((lattice.to_lattice(lattice.to_position(at)) - at).norm(),
                  1e-14 * stretch / lattice.volume());
    }
}

TEST(Lattice, TranslationsByLargeOffsetsAreExactSums) {  // law 2
    const Lattice lattice({1, 0.1, 0}, {-1, 0.1, 0.3}, {0, 0.5, 1});
    const int m = 1 << 30;
    const Vec3 sum = lattice.translation({m, m, 1});
    EXPECT_EQ(sum.x(), 0);
    EXPECT_NEAR(sum.y(), 2.0 * m * 0.1 + 0.5, 1e-7);
    EXPECT_NEAR(sum.z(), m * 0.3 + 1, 1e-7);
}

TEST(Lattice, VolumeIsThatOfTheDomain) {
    EXPECT_EQ(Lattice::box(2, 3, 5).volume(), 30);
    EXPECT_TRUE(Lattice::box(2, 3, 5).right_handed());
    const Lattice left({0, 2, 0}, {3, 0, 0}, {1, 1, 5});
    EXPECT_EQ(left.volume(), 30);
    EXPECT_FALSE(left.right_handed());
}

TEST(Lattice, HeightsAreDistancesBetweenPlanes) {
    const Vec3 heights = Lattice({2, 0, 0}, {5, 3, 0}, {1, 1, 4}).heights();
    EXPECT_NEAR(heights.z(), 4, 1e-14);
    for (const auto& [name, lattice] : lattices_and_random_ones()) {
        SCOPED_TRACE(name);
        const double area = lattice.a().cross(lattice.b()).norm();
        EXPECT_NEAR(lattice.heights().z() * area, lattice.volume(), 1e-12 * lattice.volume());
    }
}

TEST(Lattice, RejectsBadPeriods) {
    const Vec3 x(1, 0, 0);
    const Vec3 y(0, 1, 0);
    EXPECT_THROW(Lattice(x, y, Vec3(1, 1, 0)), InvalidInput);
    EXPECT_THROW(Lattice(x, y, Vec3(0, 0, 0)), InvalidInput);
    EXPECT_THROW(Lattice(x, y, Vec3(0, 0, 1e-41)), InvalidInput);
    EXPECT_THROW(Lattice(x, y, Vec3(0, 0, 1e41)), InvalidInput);
    EXPECT_THROW(Lattice(x, y, Vec3(0, 0, std::nan(""))), InvalidInput);
}

TEST(Reduction, IsAUnimodularCombination) {  // laws 1 and 3
    for (const auto& [name, lattice] : lattices_and_random_ones()) {
        SCOPED_TRACE(name);
        const Reduction r = reduce(lattice);
        Eigen::Matrix3d m;
        for (int k = 0; k < 9; ++k) m(k / 3, k % 3) = r.m[k];
        EXPECT_EQ(std::abs(m.determinant()), 1);
        EXPECT_NEAR(r.reduced.volume(), lattice.volume(), 1e-11 * lattice.volume());
        const Offset o{3, -5, 2};
        EXPECT_LT((lattice.translation(r.to_original(o)) - r.reduced.translation(o)).norm(),
                  1e-13 * 30 * (lattice.a().norm() + lattice.b().norm() + lattice.c().norm()));
    }
}

TEST(Reduction, FindsShortestVectors) {  // law 2, by trying combinations
    for (const auto& [name, lattice] : lattices_and_random_ones()) {
        SCOPED_TRACE(name);
        const Lattice r = reduce(lattice).reduced;
        EXPECT_TRUE(r.right_handed());
        for (int o = 0; o < 343; ++o) {
            const Offset offset{o / 49 - 3, o / 7 % 7 - 3, o % 7 - 3};
            const double length = r.translation(offset).norm() * (1 + 1e-9);
            // The last period that takes part.
            const int last = offset.k != 0 ? 2 : offset.j != 0 ? 1 : 0;
            if (offset == Offset{}) continue;
            EXPECT_GE(length, r.periods()[last].norm());
        }
    }
}

/// The farthest points of the cell of the origin among the lattice's own points.
TEST(Reduction, CellsLieWithinOnePeriod) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    for (const auto& [name, lattice] : lattices_and_random_ones()) {
        SCOPED_TRACE(name);
        const Lattice r = reduce(lattice).reduced;
        for (int ray = 0; ray < 200; ++ray) {
            const double u = normal(random);
            const double v = normal(random);
            const Vec3 along = r.to_position({u, v, normal(random)});
            double length = std::numeric_limits<double>::infinity();
            for (int o = 0; o < 125; ++o) {
                const Vec3 p = r.translation({o / 25 - 2, o / 5 % 5 - 2, o % 5 - 2});
                if (along.dot(p) > 0) {
                    length = std::min(length, p.squaredNorm() / 2 / along.dot(p));
                }
            }
            EXPECT_LT(r.to_lattice(length * along).cwiseAbs().maxCoeff(), 1);
        }
    }
}

TEST(Reduction, RejectsExtremeLattices) {
    EXPECT_THROW(reduce(Lattice({1, 0, 0}, {1e8 + 0.5, 1, 0}, {0, 0, 1})), InvalidInput);
    EXPECT_THROW(reduce(Lattice::box(1, 1, 2e6)), InvalidInput);
}

TEST(WrappedPoint, SplitsIntoFractionAndInteger) {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> uniform(-1000, 1000);
    for (int k = 0; k < 1000; ++k) {
        const double x = uniform(random);
        const double y = k % 2 == 0 ? std::nextafter(std::round(x), -2000) : std::round(x);
        const auto [fraction, whole] = wrap({x, y, -x});
        EXPECT_GE(fraction.minCoeff(), 0);
        EXPECT_LT(fraction.maxCoeff(), 1);
        for (const double f : fraction) EXPECT_EQ(f * kGrid, std::floor(f * kGrid));
        EXPECT_LE((fraction + whole.vector() - Vec3(x, y, -x)).cwiseAbs().maxCoeff(),
                  0x1p-51 + 0x1p-43);
    }
}

TEST(SnappedDisplacement, IsAMultipleOfTheGrid) {
    const Vec3 d = snapped_displacement({0.1, -1.3, 1e-17});
    for (const double x : d) EXPECT_EQ(x * kGrid, std::nearbyint(x * kGrid));
    EXPECT_NEAR(d.x(), 0.1, 0x1p-51);
    EXPECT_NEAR(d.y(), -1.3, 0x1p-51);
    EXPECT_EQ(d.z(), 0);
}

}  // namespace
}  // namespace pcvt::space
