#include "mesher/tetrahedra/tile_ties.hpp"

#include <gtest/gtest.h>

#include <random>

#include "mesher/tetrahedra/tetrahedral_mesh.hpp"
#include "mesher/tetrahedra/tetrahedral_proof.hpp"
#include "tests/support/polyhedra.hpp"

namespace pcvt {
namespace {

/// Random sites on cubes, slabs and oblique lattices, and those of space_cases().
std::vector<SpaceDelaunay> tied_cases() {
    std::vector<SpaceDelaunay> found;
    for (const testing::SpaceCase& c : testing::space_cases()) {
        found.push_back(space_delaunay(SpaceSites(c.lattice, c.points)));
    }
    const SpaceLattice cube = SpaceLattice::box(1, 1, 1);
    const SpaceLattice slab = SpaceLattice::box(1, 1, 0.15);
    const SpaceLattice oblique({1, 0.2, 0.1}, {-0.3, 0.9, 0.2}, {2.4, 0.3, 1.2});
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        for (const SpaceLattice& lattice : {cube, slab, oblique}) {
            const int n = 1 + static_cast<int>(seed * seed / 10);
            found.push_back(space_delaunay(SpaceSites(lattice, uniform_points(lattice, n, seed))));
        }
    }
    return found;
}

TEST(TileTies, LeaveOneImageOfEachSiteOnNoSlave) {
    for (const SpaceDelaunay& delaunay : tied_cases()) {
        const TetrahedralMesh mesh = tetrahedral_mesh(delaunay);
        SCOPED_TRACE(std::to_string(delaunay.sites.n_sites()) + " sites");
        if (!flat_tetrahedra(mesh, delaunay.sites.n_sites()).empty()) continue;
        // Proves the connection as well.
        EXPECT_EQ(n_untied_points(mesh, prove_tetrahedra(mesh)), 0);
    }
}

/// The frames of a tile of tetrahedra.
std::vector<Offset3> frames_of(const SpaceDelaunay& delaunay, const TetrahedralMesh& mesh) {
    std::vector<Offset3> frames;
    for (int t = 0; t < mesh.n_tetrahedra(); ++t) {
        const Vec3 own = delaunay.sites.position(delaunay.tetrahedra.corner(4 * t).site);
        const Vec3 u = delaunay.sites.reduction()
                           .reduced.to_lattice(mesh.points[mesh.tetrahedra[t][0]] - own)
                           .array()
                           .round();
        frames.push_back(
            {static_cast<int>(u.x()), static_cast<int>(u.y()), static_cast<int>(u.z())});
    }
    return frames;
}

TEST(TileTies, LeaveATileThatHasThem) {
    const SpaceLattice cube = SpaceLattice::box(1, 1, 1);
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const SpaceDelaunay delaunay =
            space_delaunay(SpaceSites(cube, uniform_points(cube, 40, seed)));
        const std::vector<Offset3> frames = frames_of(delaunay, tetrahedral_mesh(delaunay));
        EXPECT_EQ(tied_frames(delaunay, frames), frames);
    }
}

}  // namespace
}  // namespace pcvt
