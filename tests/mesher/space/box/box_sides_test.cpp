#include "mesher/space/box/box_sides.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "mesher/space/box/box_cells.hpp"
#include "mesher/space/grains/grains.hpp"
#include "mesher/space/proof/box_proof.hpp"
#include "mesher/space/proof/polyhedral_proof.hpp"
#include "tests/support/polyhedra.hpp"

namespace pcvt::space {
namespace {

using testing::complex_of;
using testing::SpaceCase;

PolyhedralMesh box_of(const SpaceCase& c, const Vec3& origin) {
    const Sites sites(c.lattice, c.points);
    PolyhedralMesh mesh = polyhedral_mesh(sites, cells_in_box(sites, complex_of(c), origin));
    put_on_sides(origin, mesh);
    return mesh;
}

/// The number of points of a box along the axes that have a coordinate of a lower or an upper side.
int points_on_sides(const std::vector<Vec3>& points, const Vec3& low, const Vec3& high) {
    int count = 0;
    for (const Vec3& p : points) {
        for (int d = 0; d < 3; ++d) count += p[d] == low[d] || p[d] == high[d] ? 1 : 0;
        EXPECT_TRUE((p.array() >= low.array()).all() && (p.array() <= high.array()).all());
    }
    return count;
}

/// The number of points with an offset, which lie on sides.
int points_with_images(const std::vector<Offset>& offsets) {
    int count = 0;
    for (const Offset& offset : offsets) {
        for (const int o : offset.components()) count += 2 * o;
    }
    return count;
}

TEST(BoxSides, AreFlatToTheLastBitAcrossAxes) {
    const Lattice box = Lattice::box(1.1, 0.7, 0.9);
    const SpaceCase c{"box", box, uniform_points(box, 30, 2)};
    const Vec3 origin(0.1, -0.37, 1.3);
    const PolyhedralMesh mesh = box_of(c, origin);
    const Vec3 high = origin + Vec3(1.1, 0.7, 0.9);
    EXPECT_EQ(points_on_sides(mesh.points, origin, high), points_with_images(mesh.point_offset));
    for (int p = 0; p < mesh.n_points(); ++p) {
        EXPECT_EQ(mesh.points[p],
                  mesh.points[mesh.point_orbit[p]] + box.translation(mesh.point_offset[p]));
    }
}

TEST(BoxSides, AreThoseOfTheBoxOnAllLattices) {
    for (const SpaceCase& c : testing::space_cases()) {
        if (c.points.cols() > 30) continue;
        SCOPED_TRACE(c.name);
        const Vec3 origin = c.lattice.to_position({0.3, 2.4, -0.7});
        const PolyhedralMesh mesh = box_of(c, origin);
        const std::optional<Vec3> corner = box_corner(mesh, prove_polyhedra(mesh).tolerance);
        ASSERT_TRUE(corner);
        EXPECT_EQ(*corner, origin);
    }
}

TEST(BoxCorner, RefutesWholeCellsAndBentSides) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const SpaceCase c{"random", cube, uniform_points(cube, 10, 2)};
    EXPECT_FALSE(box_corner(testing::mesh_of(c), 1e-15));
    PolyhedralMesh mesh = box_of(c, Vec3::Zero());
    ASSERT_TRUE(box_corner(mesh, 1e-15));
    const int on_side = mesh.faces[mesh.patches.front().first_face].front();
    mesh.points[on_side] += Vec3(1e-12, 1e-12, 1e-12);
    EXPECT_FALSE(box_corner(mesh, 1e-15));
}

/// The tetrahedra of the pieces fill the cells and the box, whose sides match exactly.
TEST(BoxGrains, FillTheBox) {
    for (const int n : {1, 2, 6}) {
        SCOPED_TRACE(n);
        const Lattice oblique({1, 0.2, 0.1}, {-0.3, 0.9, 0.2}, {0.4, 0.3, 1.2});
        const SpaceCase c{"oblique", oblique, uniform_points(oblique, n, 7)};
        const Sites sites(oblique, c.points);
        const CellComplex complex = complex_of(c);
        const Vec3 origin(0.1, 0.2, 0.3);
        const CellComplex pieces = cells_in_box(sites, complex, origin);
        Workers workers(2);
        Grains grains = mesh_grains(sites, pieces, {.size = sites.spacing() / 1.4, .n_rounds = 1},
                                    workers, origin);
        TetrahedralMesh& mesh = grains.mesh.tetrahedra;
        put_on_sides(origin, mesh);
        const TetrahedralProof proof = prove_tetrahedra(mesh);
        const std::optional<Vec3> corner = box_corner(mesh, proof);
        ASSERT_TRUE(corner);
        EXPECT_EQ(*corner, origin);
        std::vector<double> volumes(static_cast<std::size_t>(n), 0);
        for (int t = 0; t < mesh.n_tetrahedra(); ++t) {
            volumes[mesh.cell[t]] += tetrahedron_volume(mesh, t);
        }
        const std::vector<CellBody> bodies = cell_bodies(complex);
        for (std::size_t s = 0; s < volumes.size(); ++s) {
            EXPECT_NEAR(volumes[s] / bodies[s].volume, 1, 1e-9);
        }
    }
}

}  // namespace
}  // namespace pcvt::space
