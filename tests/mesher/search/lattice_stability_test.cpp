#include "mesher/search/lattice_stability.hpp"

#include <gmock/gmock.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "tests/support/energy_at.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt {
namespace {

using ::testing::ElementsAre;
using testing::energy_at;

const Lattice kSquare = Lattice::rectangle(1, 1);

/// The error of differences over 1e-5 h; the third derivative jumps at square lattices.
constexpr double kDifferences = 2e-5;

/// Computes the Hessian column by column from central differences of the gradient.
Eigen::MatrixXd hessian_by_differences(const LatticePattern& pattern) {
    const double step = 1e-5 * std::sqrt(pattern.basis.area());
    Points points = pattern_points(pattern);
    Eigen::MatrixXd hessian(points.size(), points.size());
    for (Eigen::Index k = 0; k < points.size(); ++k) {
        const double there = points.reshaped()[k];
        points.reshaped()[k] = there + step;
        const Points after = energy_at(pattern.period, points).gradient;
        points.reshaped()[k] = there - step;
        const Points before = energy_at(pattern.period, points).gradient;
        points.reshaped()[k] = there;
        hessian.col(k) = (after - before).reshaped() / (2 * step);
    }
    return (hessian + hessian.transpose()) / 2;
}

/// Returns the smallest eigenvalue over the largest, without the two nearest to zero, which are the
/// translations.
double smallest_by_differences(const LatticePattern& pattern) {
    Eigen::VectorXd values =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(hessian_by_differences(pattern))
            .eigenvalues();
    const double largest = values[values.size() - 1];
    std::sort(values.begin(), values.end(),
              [](double x, double y) { return std::abs(x) < std::abs(y); });
    return values.tail(values.size() - 2).minCoeff() / largest;
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
}  // namespace pcvt
