#include "tests/bench/space_peers.hpp"

#include <gtest/gtest.h>

#include "mesher/space/delaunay/mirror_diagram.hpp"

namespace pcvt::bench {
namespace {

/// The comparison is valid only if all peers do equal work: they find the same triangulation.
TEST(SpacePeers, FindTheTetrahedraOfTheMirrors) {
    const space::Lattice cube = space::Lattice::box(1, 1, 1);
    const space::Points points = uniform_points(cube, 2000, 5);
    const space::Sites sites(cube, points);
    const SpaceTriangulation plain = cgal_plain_in_space(points);
    EXPECT_EQ(plain.n_vertices, 2000);
    EXPECT_EQ(plain.n_tetrahedra, std::int64_t(euclidean_tetrahedra(sites)));
    const SpaceTriangulation periodic = cgal_periodic_in_space(points);
    EXPECT_EQ(periodic.n_vertices, 2000);
    EXPECT_EQ(periodic.n_tetrahedra, std::ssize(space::mirror_diagram(sites).tetrahedra));
}

}  // namespace
}  // namespace pcvt::bench
