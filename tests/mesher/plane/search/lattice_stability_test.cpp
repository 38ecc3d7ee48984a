#include "mesher/plane/search/lattice_stability.hpp"

#include <gmock/gmock.h>

#include "tests/support/energy_at.hpp"
#include "tests/support/example_lattices.hpp"
#include "tests/support/hessian_by_differences.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

using ::testing::ElementsAre;
using testing::energy_at;
using testing::kSquare;

/// The error of differences over 1e-5 h; the third derivative jumps at square lattices.
constexpr double kDifferences = 2e-5;

double smallest_by_differences(const LatticePattern& pattern) {
    const double step = 1e-5 * std::sqrt(pattern.basis.area());
    const auto gradient = [&](const Points& points) -> Eigen::VectorXd {
        return energy_at(pattern.period, points).gradient.reshaped();
    };
    return testing::smallest_eigenvalue(
        testing::hessian_by_differences(pattern_points(pattern), step, gradient), 2);
}

/// Law (1), at minima, saddles and a lattice with elongated cells.
TEST(LatticeStability, AgreesWithDifferencesOfTheGradient) {
    for (const auto& [name, period] : testing::lattices()) {
        for (const int n : {3, 10, 13, 18}) {
            const LatticePattern pattern = best_lattice(period, n);
            EXPECT_NEAR(*lattice_stability(pattern).smallest, smallest_by_differences(pattern),
                        kDifferences)
                << name << n;
        }
    }
    const LatticePattern bad = lattice_pattern(Lattice({1, 0}, {0.37, 0.81}), {12, 1, 1});
    EXPECT_NEAR(*lattice_stability(bad).smallest, smallest_by_differences(bad), kDifferences);
}

std::vector<int> saddles_among(int first, int last) {
    std::vector<int> saddles;
    for (int n = first; n <= last; ++n) {
        const LatticeStability stability = lattice_stability(best_lattice(kSquare, n));
        EXPECT_NE(stability.minimum, Minimum::kUnknown) << n;
        if (stability.minimum == Minimum::kNo) saddles.push_back(n);
    }
    return saddles;
}

TEST(LatticeStability, SixOfTheBestLatticesOfTheUnitSquareAreSaddles) {
    EXPECT_THAT(saddles_among(1, 400), ElementsAre(10, 13, 17, 31, 37, 65));
}

TEST(LatticeStability, OneSiteHasOnlyTheTranslations) {
    const LatticeStability stability = lattice_stability(best_lattice(kSquare, 1));
    EXPECT_EQ(stability.minimum, Minimum::kYes);
    EXPECT_FALSE(stability.smallest);
}

TEST(LatticeStability, SquaresAreASaddle) {
    EXPECT_EQ(lattice_stability(lattice_pattern(kSquare, {3, 0, 3})).minimum, Minimum::kNo);
}

TEST(LatticeStability, DoesNotDependOnTheUnitOfLength) {
    const double small = *lattice_stability(best_lattice(Lattice::rectangle(1, 2), 11)).smallest;
    const double large =
        *lattice_stability(best_lattice(Lattice::rectangle(1e55, 2e55), 11)).smallest;
    EXPECT_NEAR(small, large, 1e-12);
}

}  // namespace
}  // namespace pcvt::plane
