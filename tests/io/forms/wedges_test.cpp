#include "io/forms/wedges.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "tests/support/grid_tile.hpp"
#include "tests/support/solver_tiles.hpp"

namespace pcvt {
namespace {

constexpr double kThickness = 0.7;

std::vector<plane::Tile> tiles() {
    return testing::solver_tiles({plane::Lattice({1, 0}, {0, 1}),
                                  plane::Lattice({2, 0}, {0.25, 0.875}),
                                  plane::Lattice({0, 1}, {1, 0})});
}

ElementMesh wedges_of(const plane::Tile& tile) {
    return wedge_mesh(element_mesh(tile, solver_nodes(tile)), tile.n_vertices(), kThickness);
}

space::Vec3 node_of(const ElementMesh& mesh, int v) { return space::Vec3(mesh.nodes[v].data()); }

TEST(Wedges, ImagesAreTranslatesOfTheirRepresentativesAlongAllThreePeriods) {
    for (const plane::Tile& tile : tiles()) {
        const ElementMesh mesh = wedges_of(tile);
        const int n_layer = solver_nodes(tile).n_nodes();
        ASSERT_EQ(mesh.periods.size(), 9U);
        // Laws (1) and (2).
        EXPECT_EQ(mesh.n_nodes(), 2 * n_layer + (tile.order == 2 ? tile.n_vertices() : 0));
        int n_at_top = 0;
        for (int v = 0; v < mesh.n_nodes(); ++v) {
            const int representative = mesh.orbit[v];
            EXPECT_EQ(mesh.orbit[representative], representative);
            space::Vec3 image = node_of(mesh, representative);
            for (std::size_t k = 0; k < 3; ++k) {
                image += mesh.offsets[3 * v + k] * space::Vec3(&mesh.periods[3 * k]);
            }
            EXPECT_LT((image - node_of(mesh, v)).norm(), 1e-14);
            n_at_top += mesh.offsets[3 * v + 2];
        }
        EXPECT_EQ(n_at_top, n_layer);
    }
}

/// The volume of a wedge with straight sides, as three tetrahedra.
double volume(const ElementMesh& mesh, std::span<const int> wedge) {
    const auto tetrahedron = [&](std::array<int, 4> corners) {
        std::array<space::Vec3, 3> sides;
        for (std::size_t k = 0; k < 3; ++k) {
            sides[k] = node_of(mesh, wedge[corners[k + 1]]) - node_of(mesh, wedge[corners[0]]);
        }
        return sides[0].dot(sides[1].cross(sides[2])) / 6;
    };
    return tetrahedron({0, 1, 2, 3}) + tetrahedron({1, 2, 3, 4}) + tetrahedron({2, 4, 5, 3});
}

TEST(Wedges, FillTheLayerWithTheirMiddleNodesInTheOrderOfAbaqus) {
    // Abaqus: nodes 7 to 15 lie in the middle of these edges.
    constexpr std::array<std::array<int, 2>, 9> kEdges{
        {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}};
    for (const plane::Tile& tile : tiles()) {
        const ElementMesh mesh = wedges_of(tile);
        double sum = 0;
        for (int e = 0; e < mesh.elements.size(); ++e) {
            const auto wedge = mesh.elements.nodes[e];
            ASSERT_EQ(wedge.size(), tile.order == 2 ? 15U : 6U);
            for (std::size_t k = 6; k < wedge.size(); ++k) {
                const auto& [p, q] = kEdges[k - 6];
                const space::Vec3 middle = (node_of(mesh, wedge[p]) + node_of(mesh, wedge[q])) / 2;
                EXPECT_LT((middle - node_of(mesh, wedge[k])).norm(), 1e-14);
            }
            // Law (3).
            EXPECT_GT(volume(mesh, wedge), 0);
            sum += volume(mesh, wedge);
        }
        EXPECT_NEAR(sum, tile.lattice.area() * kThickness, 1e-13);
    }
}

TEST(Wedges, EachEdgeOfTheTorusIsSharedOnce) {
    for (const plane::Tile& tile : tiles()) {
        const TriangleCells cells(tile);
        const std::vector<SharedEdge> edges = shared_edges(tile, cells);
        // Three edges a triangle, two triangles an edge.
        EXPECT_EQ(2 * edges.size(), 3U * tile.n_faces());
        std::set<std::pair<int, int>> sides;
        for (const SharedEdge& edge : edges) {
            for (const std::size_t k : {0, 1}) {
                EXPECT_TRUE(sides.emplace(edge.faces[k], edge.sides[k]).second);
            }
            // Both sides have the same length, in opposite directions.
            std::array<plane::Vec2, 2> vectors;
            for (const std::size_t k : {0, 1}) {
                const auto corners = tile.faces[edge.faces[k]];
                vectors[k] = tile.points[corners[(edge.sides[k] + 1) % 3]] -
                             tile.points[corners[edge.sides[k]]];
            }
            EXPECT_LT((vectors[0] + vectors[1]).norm(), 1e-14);
        }
    }
}

TEST(Wedges, ACellMeetsItsImagesAcrossTheSeamOnlyWhereItIsWhole) {
    plane::Tile tile = testing::grain_grid_tile(plane::Lattice({1, 0}, {0, 1}), 2, 2);
    const auto n_between = [&] {
        const std::vector<SharedEdge> edges = shared_edges(tile, TriangleCells(tile));
        return std::count_if(edges.begin(), edges.end(),
                             [](const SharedEdge& edge) { return edge.is_between_cells; });
    };
    // Four cells, each a parallelogram of two triangles.
    EXPECT_EQ(n_between(), 8);
    for (SiteId& site : tile.face_site) site = 0;
    tile.grain_site_points.assign(8, {0.5, 0.5});
    EXPECT_EQ(n_between(), 4);
    // The lower and the upper row are parts of two images, which the seam at the bottom only cuts.
    for (int f = 0; f < 8; ++f) tile.grain_site_points[f] = {0.5, f < 4 ? 0 : 1};
    EXPECT_EQ(n_between(), 4);
}

}  // namespace
}  // namespace pcvt
