#include "mesher/cells/misorientations.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesher/cells/orientations.hpp"

namespace pcvt {
namespace {

constexpr double kDegreeOfArc = M_PI / 180;

/// The 24 rotations of the cube: signed permutation matrices with determinant 1.
std::vector<Eigen::Matrix3d> cube_rotations() {
    std::vector<Eigen::Matrix3d> rotations;
    std::array<int, 3> axes{0, 1, 2};
    do {
        for (int signs = 0; signs < 8; ++signs) {
            Eigen::Matrix3d rotation = Eigen::Matrix3d::Zero();
            for (int k = 0; k < 3; ++k) rotation(k, axes[k]) = (signs >> k & 1) == 0 ? 1 : -1;
            if (rotation.determinant() > 0) rotations.push_back(rotation);
        }
    } while (std::next_permutation(axes.begin(), axes.end()));
    return rotations;
}

TEST(Misorientations, Law1AreTheLeastAnglesOverAllSymmetricOrientations) {
    const std::vector<Eigen::Matrix3d> cube = cube_rotations();
    ASSERT_EQ(cube.size(), 24U);
    const std::vector<BungeAngles> drawn = random_orientations(400, 7);
    for (std::size_t k = 0; k + 1 < drawn.size(); k += 2) {
        const Eigen::Matrix3d one = bunge_matrix(drawn[k]);
        const Eigen::Matrix3d other = bunge_matrix(drawn[k + 1]);
        double trace = -1;
        for (const Eigen::Matrix3d& a : cube) {
            for (const Eigen::Matrix3d& b : cube) {
                trace = std::max(trace, (a * one * (b * other).transpose()).trace());
            }
        }
        EXPECT_NEAR(cubic_disorientation(drawn[k], drawn[k + 1]),
                    std::acos((trace - 1) / 2) / kDegreeOfArc, 1e-9);
    }
}

TEST(Misorientations, OfSymmetricAndOfTurnedCrystalsAreKnown) {
    EXPECT_NEAR(cubic_disorientation({10, 20, 30}, {10, 20, 120}), 0, 1e-6);
    EXPECT_NEAR(cubic_disorientation({0, 0, 0}, {90, 90, -90}), 0, 1e-6);
    EXPECT_NEAR(cubic_disorientation({10, 20, 30}, {10, 20, 45}), 15, 1e-9);
    EXPECT_NEAR(cubic_disorientation({0, 0, 0}, {45, 0, 0}), 45, 1e-9);
    EXPECT_EQ(cubic_disorientation({1, 2, 3}, {1, 2, 3}),
              cubic_disorientation({4, 5, 6}, {4, 5, 6}));
}

/// The integral of Mackenzie's density of disorientations without a texture from 0 to an angle of
/// at most 60 degrees (J. K. Mackenzie, Biometrika 45, 1958).
double mackenzie(double degrees) {
    const double root = std::sqrt(2.0) - 1;
    const auto below_45 = [](double x) { return x - std::sin(x); };
    const auto above_45 = [&](double x) { return -3 * root * std::cos(x) - 2 * below_45(x); };
    const double x = degrees * kDegreeOfArc;
    const double middle = 45 * kDegreeOfArc;
    // The density is 2 / 15 for each degree.
    const double per_radian = 2.0 / 15 / kDegreeOfArc;
    if (degrees <= 45) return per_radian * below_45(x);
    return per_radian * (below_45(middle) + above_45(x) - above_45(middle));
}

/// Cells of which each is the neighbour of the next.
CellTable chain(int n) {
    CellTable cells;
    cells.measure.assign(n, 1);
    for (int s = 0; s < n; ++s) {
        if (s > 0) cells.neighbours.push_back(s - 1);
        if (s + 1 < n) cells.neighbours.push_back(s + 1);
        cells.neighbour_begin.push_back(static_cast<int>(cells.neighbours.size()));
    }
    return cells;
}

TEST(Misorientations, Law2WithoutATextureHaveMackenziesDistribution) {
    const int n = 40'000;
    const auto found =
        misorientations(chain(n), {.site_orientation = random_orientations(n, 11)}).value();
    EXPECT_EQ(found.n_boundaries, n - 1);
    EXPECT_EQ(std::accumulate(found.counts.begin(), found.counts.end(), 0), n - 1);
    EXPECT_NEAR(found.mean, 40.736, 0.3);
    EXPECT_GT(found.largest, 60);
    EXPECT_LT(found.largest, 62.8);
    double fraction = 0;
    for (int k = 0; k < 24; ++k) {
        fraction += found.counts[k] / double(n - 1);
        const double wanted = mackenzie((k + 1) * Misorientations::kClass);
        // Kolmogorov and Smirnov's test, at the level of 0.1 %.
        EXPECT_NEAR(fraction, wanted, 1.95 / std::sqrt(n)) << k;
    }
}

TEST(Misorientations, CountEachBoundaryBetweenCrystalsOfOnePhaseOnce) {
    const std::vector<BungeAngles> turned{{0, 0, 0}, {10, 0, 0}, {30, 0, 0}, {40, 0, 0}};
    CellMaterials materials{.site_orientation = turned};
    auto found = misorientations(chain(4), materials).value();
    EXPECT_EQ(found.n_boundaries, 3);
    EXPECT_EQ(found.counts[3] + found.counts[4], 2);
    EXPECT_EQ(found.counts[7] + found.counts[8], 1);
    EXPECT_NEAR(found.mean, 40.0 / 3, 1e-9);
    materials.phase_names = {"a", "b"};
    materials.site_phase = {0, 0, 1, 1};
    EXPECT_EQ(misorientations(chain(4), materials)->n_boundaries, 2);
    materials.site_phase = {0, 1, 0, 1};
    EXPECT_FALSE(misorientations(chain(4), materials).has_value());
    EXPECT_FALSE(misorientations(chain(4), {}).has_value());
    // A cell that touches itself, and another one twice.
    CellTable pair;
    pair.measure = {1, 1};
    pair.neighbour_begin = {0, 4, 8};
    pair.neighbours = {0, 0, 1, 1, 0, 0, 1, 1};
    EXPECT_EQ(misorientations(pair, {.site_orientation = {turned[0], turned[1]}})->n_boundaries, 2);
}

}  // namespace
}  // namespace pcvt
