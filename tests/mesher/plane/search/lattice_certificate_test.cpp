#include "mesher/plane/search/lattice_certificate.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/example_lattices.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

using testing::kSquare;

CvtResult tessellation(const Lattice& period, Points points) {
    CvtOptions as_given;
    as_given.run.max_iterations = 0;
    return compute_cvt(period, std::move(points), as_given);
}

/// Returns the sites in random order, moved by a common vector and each by up to `noise` h.
Points shuffled(const LatticePattern& pattern, double noise, std::mt19937_64& random) {
    std::uniform_real_distribution<double> uniform(-1, 1);
    Points points = pattern_points(pattern);
    const double h = std::sqrt(pattern.basis.area());
    const Vec2 common(7.3 * h, -2.1 * h);
    for (Eigen::Index s = points.cols() - 1; s > 0; --s) {
        const Eigen::Index t = std::uniform_int_distribution<Eigen::Index>(0, s)(random);
        points.col(s).swap(points.col(t));
    }
    for (Eigen::Index s = 0; s < points.cols(); ++s) {
        points.col(s) += common + noise * h / std::sqrt(2) * Vec2{uniform(random), uniform(random)};
    }
    return points;
}

TEST(AsLattice, FindsTheLatticeThatTheSitesWereTakenFrom) {
    std::mt19937_64 random(1);
    for (const auto& [name, period] : testing::lattices()) {
        for (const int n : {1, 2, 3, 4, 12, 30, 97, 2003}) {
            for (const LatticePattern& pattern : best_lattices(period, n, 2)) {
                const auto found =
                    as_lattice(tessellation(period, shuffled(pattern, 0.1 * kOffLattice, random)));
                ASSERT_TRUE(found) << name << n;
                EXPECT_EQ(found->form, pattern.form) << name << n;
            }
        }
    }
}

TEST(AsLattice, FindsNoneWhereOneSiteIsOff) {
    const LatticePattern pattern = best_lattice(kSquare, 56);
    const double h = std::sqrt(pattern.basis.area());
    for (const double off : {0.5, 2.0}) {
        Points points = pattern_points(pattern);
        points(0, 7) += off * kOffLattice * h;
        EXPECT_EQ(as_lattice(tessellation(kSquare, points)).has_value(), off < 1);
    }
}

TEST(AsLattice, FindsNoneForRandomSites) {
    for (int n = 2; n <= 40; ++n) {
        EXPECT_FALSE(as_lattice(tessellation(kSquare, uniform_points(kSquare, n, 3)))) << n;
    }
}

TEST(AsLattice, FindsNoneForALatticeWithAnExtraSite) {
    Points points(2, 31);
    points << pattern_points(best_lattice(kSquare, 30)), Vec2(0.511, 0.487);
    EXPECT_FALSE(as_lattice(tessellation(kSquare, points)));
}

TEST(AsLattice, CertifiesAnAllHexagonResultOfARandomStart) {
    CvtOptions options;
    options.run.tolerance = 1e-8;
    const CvtResult result = compute_cvt(kSquare, uniform_points(kSquare, 18, 4), options);
    const auto found = as_lattice(result);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->energy / result.run.energy, 1, 1e-12);
}

}  // namespace
}  // namespace pcvt::plane
