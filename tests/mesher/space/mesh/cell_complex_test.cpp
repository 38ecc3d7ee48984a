#include "mesher/space/mesh/cell_complex.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <set>

#include "tests/support/polyhedra.hpp"

namespace pcvt::space {
namespace {

using testing::complex_of;
using testing::space_cases;
using testing::SpaceCase;

/// Law (1).
TEST(CellComplex, FacesRunCounterClockwiseSeenFromOutside) {
    for (const SpaceCase& c : space_cases()) {
        const CellComplex complex = complex_of(c);
        const Sites sites(c.lattice, c.points);
        for (int f = 0; f < complex.n_faces(); ++f) {
            const auto corners = complex.corners_of(f);
            ASSERT_GE(std::set(corners.begin(), corners.end()).size(), 3U) << c.name;
            Vec3 normal = Vec3::Zero();
            for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
                const Vec3 first = complex.position(corners[0]);
                normal += (complex.position(corners[k]) - first)
                              .cross(complex.position(corners[k + 1]) - first);
            }
            const CellFace& face = complex.faces[f];
            const Vec3 across = sites.position(face.neighbour) +
                                complex.reduced.translation(face.offset) -
                                sites.position(face.cell);
            if (normal.norm() < 1e-9 * across.squaredNorm()) continue;
            EXPECT_GT(normal.dot(across) / normal.norm() / across.norm(), 0.999) << c.name;
        }
    }
}

/// Law (2).
TEST(CellComplex, FacesOfEachCellClose) {
    for (const SpaceCase& c : space_cases()) {
        const CellComplex complex = complex_of(c);
        std::map<std::tuple<SiteId, VertexImage, VertexImage>, int> sides;
        for (int f = 0; f < complex.n_faces(); ++f) {
            const CellFace& face = complex.faces[f];
            const auto corners = complex.corners_of(f);
            for (std::size_t k = 0; k < corners.size(); ++k) {
                VertexImage v = corners[k];
                VertexImage w = corners[(k + 1) % corners.size()];
                ++sides[{face.cell, v, w}];
                v.offset = v.offset - face.offset;
                w.offset = w.offset - face.offset;
                ++sides[{face.neighbour, w, v}];
            }
        }
        for (const auto& [side, count] : sides) {
            EXPECT_EQ(count, 1) << c.name;
            const auto& [cell, v, w] = side;
            EXPECT_TRUE(sides.contains({cell, w, v})) << c.name;
        }
    }
}

/// Law (3).
TEST(CellComplex, CornersAreEquallyFarFromTheirSites) {
    for (const SpaceCase& c : space_cases()) {
        const CellComplex complex = complex_of(c);
        const Sites sites(c.lattice, c.points);
        for (int f = 0; f < complex.n_faces(); ++f) {
            const CellFace& face = complex.faces[f];
            const Vec3 here = sites.position(face.cell);
            const Vec3 there =
                sites.position(face.neighbour) + complex.reduced.translation(face.offset);
            for (const VertexImage& corner : complex.corners_of(f)) {
                const Vec3 p = complex.position(corner);
                EXPECT_NEAR((p - here).norm(), (p - there).norm(), 1e-8 * sites.spacing())
                    << c.name;
            }
        }
    }
}

TEST(CellComplex, OfLatticesHasTheFacesOfTheirPolyhedra) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const std::pair<Points, int> known[] = {
        {testing::lattice_points(16), 14}, {testing::lattice_points(54), 14},
        {testing::lattice_points(4), 12},  {testing::lattice_points(32), 12},
        {testing::grid_points(1), 6},      {testing::grid_points(3), 6},
    };
    for (const auto& [points, faces] : known) {
        const CellComplex complex = complex_of({"", cube, points});
        // Each face belongs to two cells.
        EXPECT_EQ(2 * complex.n_faces(), faces * complex.n_cells);
        for (int f = 0; f < complex.n_faces(); ++f) {
            const auto n = complex.corners_of(f).size();
            EXPECT_TRUE(n == 4 || (n == 6 && faces == 14)) << n;
        }
    }
}

/// Flat tetrahedra between two others hide that the centres of these are one: 38 sites.
TEST(CellComplex, HasNoEdgesOfTheLengthOfRounding) {
    const Lattice cube = Lattice::box(1, 1, 1);
    for (int n = 1; n <= 40; ++n) {
        const CellComplex complex = complex_of({"", cube, testing::lattice_points(n)});
        for (int f = 0; f < complex.n_faces(); ++f) {
            const auto corners = complex.corners_of(f);
            for (std::size_t k = 0; k < corners.size(); ++k) {
                const Vec3 next = complex.position(corners[(k + 1) % corners.size()]);
                EXPECT_GT((complex.position(corners[k]) - next).norm(), 1e-3) << n;
            }
        }
    }
}

/// Moments of cells give the energies in closed form.
TEST(CellBodies, HaveTheMomentsOfLattices) {
    const Lattice cube = Lattice::box(1, 1, 1);
    for (int n = 1; n <= 40; ++n) {
        const LatticePattern pattern = best_lattice(Eigen::Matrix3d::Identity(), n);
        const SpaceCase c{"", cube, pattern_points(pattern)};
        const Sites sites(c.lattice, c.points);
        const std::vector<CellBody> bodies = cell_bodies(complex_of(c));
        double energy = 0;
        for (int s = 0; s < n; ++s) {
            EXPECT_NEAR(bodies[s].volume * n, 1, 1e-11) << n;
            EXPECT_LT((bodies[s].centroid - sites.position(s)).norm(), 1e-11) << n;
            energy += bodies[s].moment;
        }
        EXPECT_NEAR(energy / pattern.energy, 1, 1e-11) << n;
    }
}

TEST(CellBodies, FillTheDomain) {
    for (const SpaceCase& c : space_cases()) {
        double sum = 0;
        for (const CellBody& body : cell_bodies(complex_of(c))) sum += body.volume;
        EXPECT_NEAR(sum / c.lattice.volume(), 1, 1e-12) << c.name;
    }
}

}  // namespace
}  // namespace pcvt::space
