#include "mesher/space/mesh/tile_ties.hpp"

#include <gtest/gtest.h>

#include <random>

#include "mesher/space/mesh/tetrahedral_mesh.hpp"
#include "mesher/space/proof/tetrahedral_proof.hpp"
#include "tests/support/polyhedra.hpp"

namespace pcvt::space {
namespace {

/// Random sites on cubes, slabs and oblique lattices, and those of space_cases().
std::vector<PeriodicDelaunay> tied_cases() {
    std::vector<PeriodicDelaunay> found;
    for (const testing::SpaceCase& c : testing::space_cases()) {
        found.push_back(periodic_delaunay(Sites(c.lattice, c.points)));
    }
    const Lattice cube = Lattice::box(1, 1, 1);
    const Lattice slab = Lattice::box(1, 1, 0.15);
    const Lattice oblique({1, 0.2, 0.1}, {-0.3, 0.9, 0.2}, {2.4, 0.3, 1.2});
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        for (const Lattice& lattice : {cube, slab, oblique}) {
            const int n = 1 + static_cast<int>(seed * seed / 10);
            found.push_back(periodic_delaunay(Sites(lattice, uniform_points(lattice, n, seed))));
        }
    }
    return found;
}

TEST(TileTies, LeaveOneImageOfEachSiteOnNoSlave) {
    for (const PeriodicDelaunay& delaunay : tied_cases()) {
        const TetrahedralMesh mesh = tetrahedral_mesh(delaunay);
        SCOPED_TRACE(std::to_string(delaunay.sites.n_sites()) + " sites");
        if (!flat_tetrahedra(mesh, delaunay.sites.n_sites()).empty()) continue;
        // Proves the connection as well.
        EXPECT_EQ(n_untied_points(mesh, prove_tetrahedra(mesh)), 0);
    }
}

/// The frames of a tile of tetrahedra.
std::vector<Offset> frames_of(const PeriodicDelaunay& delaunay, const TetrahedralMesh& mesh) {
    std::vector<Offset> frames;
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
    const Lattice cube = Lattice::box(1, 1, 1);
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const PeriodicDelaunay delaunay =
            periodic_delaunay(Sites(cube, uniform_points(cube, 40, seed)));
        const std::vector<Offset> frames = frames_of(delaunay, tetrahedral_mesh(delaunay));
        EXPECT_EQ(tied_frames(delaunay, frames), frames);
    }
}

}  // namespace
}  // namespace pcvt::space
