#include "mesher/space/box/box_origin.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>

#include "mesher/space/box/plane_cut.hpp"
#include "tests/support/polyhedra.hpp"

namespace pcvt::space {
namespace {

using testing::complex_of;
using testing::SpaceCase;

double degrees(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / M_PI;
}

double penalty(double angle) { return angle < 25 ? (25 - angle) * (25 - angle) : 0; }

/// The sum over the angles of cut cells at new vertices: corners of all faces, and the dihedral
/// angles at the faces in planes.
double sum_of_cut(const SpaceCase& c, double plane) {
    CutCells cells{.complex = complex_of(c)};
    const auto n_old = static_cast<int>(cells.complex.vertices.size());
    cells.cell.resize(static_cast<std::size_t>(cells.complex.n_cells));
    std::iota(cells.cell.begin(), cells.cell.end(), 0);
    cells.slab.resize(cells.cell.size());
    cells.level.resize(cells.complex.vertices.size());
    EXPECT_TRUE(cut_along(2, {0, 0, plane}, {1e-12}, cells));
    const CellComplex& complex = cells.complex;
    double sum = 0;
    for (int f = 0; f < complex.n_faces(); ++f) {
        const auto corners = complex.corners_of(f);
        const std::size_t n = corners.size();
        std::size_t n_new = 0;
        Vec3 normal = Vec3::Zero();
        bool has_new_edge = false;
        for (std::size_t k = 0; k < n; ++k) {
            const Vec3 at = complex.position(corners[k]);
            const Vec3 next = complex.position(corners[(k + 1) % n]) - at;
            const Vec3 before = complex.position(corners[(k + n - 1) % n]) - at;
            normal += at.cross(at + next);
            if (corners[k].vertex < n_old) continue;
            ++n_new;
            sum += penalty(degrees(next, before));
            has_new_edge |= corners[(k + 1) % n].vertex >= n_old;
        }
        if (n_new == n || !has_new_edge) continue;
        const double tilt = degrees(normal, {0, 0, 1});
        // In the cell and, turned over, in its neighbour.
        sum += penalty(std::min(tilt, 180 - tilt));
    }
    return sum;
}

/// The faces below and above a plane have one small dihedral angle each.
TEST(BoxOrigin, SumsTheAnglesOfCutCells) {
    const Lattice cube = Lattice::box(1, 1, 1);
    for (const std::uint64_t seed : {1, 2, 3}) {
        const SpaceCase c{"random", cube, uniform_points(cube, 40, seed)};
        const Sites sites(cube, c.points);
        for (const double plane : {0.013, 0.31, 0.77}) {
            const double expected = sum_of_cut(c, plane);
            EXPECT_GT(expected, 0);
            EXPECT_NEAR(narrow_angles(sites, complex_of(c), 2, plane), expected, 1e-6 * expected);
        }
    }
}

/// A plane 0.02 h above the lower faces of the cells of a grid, and below the upper ones.
TEST(BoxOrigin, SumsThinPieces) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const SpaceCase c{"grid", cube, testing::grid_points(2)};
    const Sites sites(cube, c.points);
    const double face = sites.position(0).z() + 0.25;
    for (const double d : {0.01, -0.01}) {
        EXPECT_NEAR(thin_pieces(sites, complex_of(c), 2, face + d), 4 * 20 * 20, 1e-6);
    }
    EXPECT_EQ(thin_pieces(sites, complex_of(c), 2, face), 0);
    EXPECT_EQ(thin_pieces(sites, complex_of(c), 2, face + 0.2), 0);
}

/// Laws (1) and (2).
TEST(BoxOrigin, IsTheBestOfItsPositions) {
    const Lattice oblique({1, 0.2, 0.1}, {-0.3, 0.9, 0.2}, {0.4, 0.3, 1.2});
    const SpaceCase c{"oblique", oblique, uniform_points(oblique, 30, 4)};
    const Sites sites(oblique, c.points);
    const CellComplex complex = complex_of(c);
    const Vec3 u = oblique.to_lattice(best_box_origin(sites, complex));
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GT(u[axis], 0);
        EXPECT_LT(u[axis], 1);
        const auto cost = [&](double plane) {
            return narrow_angles(sites, complex, axis, plane) +
                   thin_pieces(sites, complex, axis, plane);
        };
        const double chosen = cost(u[axis]);
        for (int k = 0; k < 200; ++k) EXPECT_LE(chosen, cost((k + 0.5) / 200) + 1e-3);
    }
}

/// Equal positions of lattices differ in their distance from the vertices.
TEST(BoxOrigin, LiesOffVerticesOfLattices) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const SpaceCase c{"grid", cube, testing::grid_points(2)};
    const Sites sites(cube, c.points);
    const Vec3 u = best_box_origin(sites, complex_of(c));
    for (int axis = 0; axis < 3; ++axis) {
        const double from_site = std::abs(2 * u[axis] - std::round(2 * u[axis]));
        EXPECT_LT(std::min(from_site, 0.5 - from_site), 0.01);
    }
}

}  // namespace
}  // namespace pcvt::space
