#include "tests/bench/peers.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>
#include <gmock/gmock.h>

#include <iterator>
#include <vector>

#include "mesher/plane/geometry/sites.hpp"

namespace pcvt::bench {
namespace {

/// The comparison is valid only if all peers do equal work: they find the same triangulation.
class Peers : public ::testing::TestWithParam<int> {
   protected:
    plane::Points points_ = uniform_points(plane::Lattice::rectangle(1, 1), GetParam(), 5);
};

void expect_diagram(const Diagram& diagram, std::int64_t n_vertices, std::int64_t n_triangles) {
    EXPECT_EQ(diagram.n_vertices, n_vertices);
    EXPECT_EQ(diagram.n_triangles, n_triangles);
    EXPECT_NE(diagram.structure, nullptr);
}

std::int64_t n_hull_corners(const plane::Points& points) {
    using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
    std::vector<Point> all;
    for (const auto& p : points.colwise()) all.emplace_back(p.x(), p.y());
    std::vector<Point> corners;
    CGAL::convex_hull_2(all.begin(), all.end(), std::back_inserter(corners));
    return std::ssize(corners);
}

TEST_P(Peers, PlainFillsTheConvexHull) {
    const int n = GetParam();
    expect_diagram(cgal_plain(points_), n, 2 * n - 2 - n_hull_corners(points_));
}

TEST_P(Peers, NineCopiesHoldEachPeriodicTriangleOnce) {
    const int n = GetParam();
    expect_diagram(cgal_nine_copies(points_), 9 * n, 2 * n);
}

// A hundred random sites leave edges too long for the one-sheeted cover.
TEST_P(Peers, PeriodicFindsTwoTrianglesASite) {
    const int n = GetParam();
    expect_diagram(cgal_periodic(points_), n < 1000 ? 9 * n : n, 2 * n);
}

TEST_P(Peers, MirrorsFindTwoTrianglesASite) {
    const int n = GetParam();
    expect_diagram(mirrors(points_), n, 2 * n);
}

TEST_P(Peers, VoroFillsTheSquareWithCells) {
    const int n = GetParam();
    const Diagram diagram = voro_prisms(points_);
    expect_diagram(diagram, n, 2 * n);
    EXPECT_NEAR(diagram.area.value(), 1, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Sites, Peers, ::testing::Values(100, 1000));

}  // namespace
}  // namespace pcvt::bench
