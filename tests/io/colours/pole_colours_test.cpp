#include "io/colours/pole_colours.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "mesher/cells/orientations.hpp"

namespace pcvt {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

/// The 24 rotations of a cube as matrices.
std::vector<Eigen::Matrix3d> cube_rotations() {
    std::vector<Eigen::Matrix3d> rotations;
    std::array<int, 3> order{0, 1, 2};
    do {
        for (int signs = 0; signs < 8; ++signs) {
            Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
            for (int k = 0; k < 3; ++k) m(k, order[k]) = (signs >> k & 1) == 0 ? 1 : -1;
            if (m.determinant() > 0) rotations.push_back(m);
        }
    } while (std::next_permutation(order.begin(), order.end()));
    return rotations;
}

/// The colour of the one image of the axis that lies in the triangle of <001>, <011> and <111>.
Rgb colour_by_search(const Eigen::Vector3d& axis) {
    const Eigen::Vector3d corners[] = {{0, 0, 1}, {0, 1, 1}, {1, 1, 1}};
    Eigen::Matrix3d basis;
    for (int k = 0; k < 3; ++k) basis.col(k) = corners[k].normalized();
    for (const Eigen::Matrix3d& rotation : cube_rotations()) {
        for (const double sign : {1.0, -1.0}) {
            const Eigen::Vector3d parts = basis.inverse() * (sign * (rotation * axis));
            if (parts.minCoeff() < 0) continue;
            Rgb colour{};
            for (int k = 0; k < 3; ++k) {
                colour[k] =
                    static_cast<std::uint8_t>(std::lround(255 * parts[k] / parts.maxCoeff()));
            }
            return colour;
        }
    }
    ADD_FAILURE() << "no image lies in the triangle";
    return {};
}

TEST(PoleColours, AreRedGreenAndBlueAtTheCorners) {
    EXPECT_EQ(pole_colour({0, 0, 0}), (Rgb{255, 0, 0}));
    EXPECT_EQ(pole_colour({70, 90, 0}), (Rgb{255, 0, 0}));
    EXPECT_EQ(pole_colour({0, 45, 0}), (Rgb{0, 255, 0}));
    EXPECT_EQ(pole_colour({10, std::acos(1 / std::numbers::sqrt3) * 180 / std::numbers::pi, 45}),
              (Rgb{0, 0, 255}));
}

TEST(PoleColours, EqualThoseOfASearchOverAllSymmetries) {
    for (const BungeAngles& angles : random_orientations(2000, 5)) {
        EXPECT_EQ(pole_colour(angles), colour_by_search(bunge_matrix(angles).col(2)));
    }
}

TEST(PoleColours, DoNotDependOnSymmetriesOrTurnsAboutTheAxis) {
    for (const BungeAngles& a : random_orientations(500, 9)) {
        EXPECT_EQ(pole_colour(a), pole_colour({a.phi1 / 2, a.Phi, a.phi2}));
        EXPECT_EQ(pole_colour(a), pole_colour({a.phi1, a.Phi, a.phi2 - 90}));
    }
}

}  // namespace
}  // namespace pcvt
