#include "mesher/space/grains/grain_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "mesher/space/box/box_cells.hpp"
#include "mesher/space/grains/cell_hull.hpp"
#include "mesher/space/grains/cell_sizes.hpp"
#include "mesher/space/grains/face_heights.hpp"
#include "mesher/space/grains/grains.hpp"
#include "mesher/space/grains/tetrahedron_shape.hpp"
#include "mesher/space/proof/tetrahedral_proof.hpp"
#include "tests/support/polyhedra.hpp"

namespace pcvt::space {
namespace {

std::vector<testing::SpaceCase> few_cases() {
    std::vector<testing::SpaceCase> kept;
    for (testing::SpaceCase& c : testing::space_cases()) {
        if (c.points.cols() <= 30 && c.name.find("thin") == std::string::npos) {
            kept.push_back(std::move(c));
        }
    }
    return kept;
}

std::vector<double> sizes_of(const CellComplex& complex) {
    const double h = std::cbrt(complex.reduced.volume() / complex.n_cells);
    return std::vector<double>(static_cast<std::size_t>(complex.n_cells), h / 2);
}

GrainSurface surface_of(const CellComplex& complex, int n_threads = 1) {
    Workers workers(n_threads);
    return grain_surface(complex, sizes_of(complex), workers);
}

/// The first law of cell_edges().
TEST(CellEdges, EachEdgeOfAFaceIsTheImageOfOneEdge) {
    for (const testing::SpaceCase& c : few_cases()) {
        SCOPED_TRACE(c.name);
        const CellComplex complex = testing::complex_of(c);
        const CellEdges edges = cell_edges(complex, sizes_of(complex));
        // Each vertex, edge, face and cell once: the torus.
        EXPECT_EQ(static_cast<int>(complex.vertices.size()) - static_cast<int>(edges.edges.size()) +
                      complex.n_faces() - complex.n_cells,
                  0);
        for (int f = 0; f < complex.n_faces(); ++f) {
            const auto corners = complex.corners_of(f);
            for (std::size_t k = 0; k < corners.size(); ++k) {
                const EdgeUse& use = edges.uses[complex.begin[f] + static_cast<int>(k)];
                VertexImage from = edges.edges[use.edge].from;
                VertexImage to = edges.edges[use.edge].to;
                for (VertexImage* end : {&from, &to}) end->offset = end->offset + use.offset;
                if (use.reversed) std::swap(from, to);
                EXPECT_EQ(from, corners[k]);
                EXPECT_EQ(to, corners[(k + 1) % corners.size()]);
            }
        }
    }
}

/// Law (2) of cell_edges(): parts grow from the smallest features to the size of the cells.
TEST(CellEdges, PartsAreNoLongerThanTheSize) {
    const CellComplex complex = testing::complex_of(few_cases().back());
    const std::vector<double> sizes = sizes_of(complex);
    for (const CellEdge& edge : cell_edges(complex, sizes).edges) {
        const double whole = distance(complex.position(edge.from), complex.position(edge.to));
        double before = 0;
        for (const double cut : edge.cuts) {
            EXPECT_GT(cut, before);
            EXPECT_LT((cut - before) * whole, 1.5 * sizes[0]);
            before = cut;
        }
        EXPECT_LT((1 - before) * whole, 1.5 * sizes[0]);
    }
}

/// Cells cut by a box whose sides lie 1e-6 beside a vertex.
CellComplex thin_pieces() {
    const PeriodicDelaunay delaunay = periodic_delaunay(
        Sites(Lattice::box(1, 1, 1), uniform_points(Lattice::box(1, 1, 1), 3, 4)));
    const CellComplex cells = cell_complex(delaunay.sites, delaunay.tetrahedra);
    return cells_in_box(delaunay.sites, cells, cells.vertices.front() + Vec3(1e-6, 1e-6, 1e-6));
}

/// Law (3) of cell_edges().
TEST(CellEdges, PartsGrowFromTheSizesAtTinyFeatures) {
    const CellComplex complex = thin_pieces();
    const CellEdges edges = cell_edges(complex, sizes_of(complex));
    EXPECT_LT(*std::min_element(edges.vertex_size.begin(), edges.vertex_size.end()), 1e-5);
    for (const CellEdge& edge : edges.edges) {
        if (edge.cuts.empty()) continue;
        const double whole = distance(complex.position(edge.from), complex.position(edge.to));
        EXPECT_LT(edge.cuts.front() * whole, 2.5 * edges.vertex_size[edge.from.vertex]);
        EXPECT_LT((1 - edge.cuts.back()) * whole, 2.5 * edges.vertex_size[edge.to.vertex]);
    }
}

TEST(GrainSurface, NoTriangleHasPointsOfOneLine) {
    const CellComplex complex = thin_pieces();
    const GrainSurface surface = surface_of(complex);
    std::size_t n_triangles = 0;
    for (int f = 0; f < complex.n_faces(); ++f) {
        n_triangles += surface.triangles[f].size();
        for (const SurfaceTriangle& t : surface.triangles[f]) {
            const Vec3 a = surface.position(complex, t[0]);
            const Vec3 b = surface.position(complex, t[1]) - a;
            const Vec3 c = surface.position(complex, t[2]) - a;
            EXPECT_GT(length(cross_product(b, c)),
                      1e-8 * std::max(squared_length(b), squared_length(c)));
        }
    }
    EXPECT_LT(n_triangles, 500u * complex.faces.size());
}

TEST(Grains, ThinPiecesOfBoxesAreFilledSlow) {
    const Lattice cube = Lattice::box(1, 1, 1);
    Workers one_worker(1);
    const Sites sites(cube, uniform_points(cube, 3, 4));
    const Grains grains =
        mesh_grains(sites, thin_pieces(), {.size = sites.spacing() / 2, .n_rounds = 0}, one_worker);
    EXPECT_NO_THROW(prove_tetrahedra(grains.mesh.tetrahedra));
}

/// Law (1).
TEST(GrainSurface, TrianglesCoverPlaneFaces) {
    for (const testing::SpaceCase& c : few_cases()) {
        SCOPED_TRACE(c.name);
        const CellComplex complex = testing::complex_of(c);
        const GrainSurface surface = surface_of(complex);
        const double h = std::cbrt(complex.reduced.volume() / complex.n_cells);
        for (int f = 0; f < complex.n_faces(); ++f) {
            const FacePlane plane = face_plane(complex, f);
            double area = 0;
            for (const SurfaceTriangle& t : surface.triangles[f]) {
                const Vec3 a = surface.position(complex, t[0]);
                const Vec3 b = surface.position(complex, t[1]);
                const Vec3 p = surface.position(complex, t[2]);
                const double part = dot_product(cross_product(b - a, p - a), plane.normal);
                EXPECT_GT(part, 0);
                area += part;
                EXPECT_NEAR(dot_product(p - plane.origin, plane.normal), 0, 1e-12 * h);
            }
            Vec3 whole = Vec3::Zero();
            const auto corners = complex.corners_of(f);
            for (std::size_t k = 0; k < corners.size(); ++k) {
                whole += cross_product(
                    complex.position(corners[k]) - plane.origin,
                    complex.position(corners[(k + 1) % corners.size()]) - plane.origin);
            }
            EXPECT_NEAR(area, length(whole), 1e-12 * h * h);
        }
    }
}

/// Law (2), and the law of cell_hulls().
TEST(GrainSurface, HullsOfCellsClose) {
    for (const testing::SpaceCase& c : few_cases()) {
        SCOPED_TRACE(c.name);
        const CellComplex complex = testing::complex_of(c);
        const GrainSurface surface = surface_of(complex);
        for (const CellHull& hull : cell_hulls(complex, surface)) {
            std::set<std::pair<int, int>> edges;
            for (const auto& t : hull.triangles) {
                for (int k = 0; k < 3; ++k) {
                    EXPECT_TRUE(edges.emplace(t[k], t[(k + 1) % 3]).second);
                }
            }
            for (const auto& [a, b] : edges) EXPECT_TRUE(edges.contains({b, a}));
            EXPECT_EQ(static_cast<int>(hull.points.size()) - static_cast<int>(edges.size()) / 2 +
                          static_cast<int>(hull.triangles.size()),
                      2);
            EXPECT_TRUE(kernel_point(hull).has_value());
        }
    }
}

/// Law (3).
TEST(GrainSurface, BytesDoNotDependOnThreads) {
    const CellComplex complex = testing::complex_of(few_cases().back());
    const GrainSurface one = surface_of(complex);
    const GrainSurface four = surface_of(complex, 4);
    ASSERT_EQ(one.nodes.size(), four.nodes.size());
    for (std::size_t v = 0; v < one.nodes.size(); ++v) {
        EXPECT_EQ(one.nodes[v].position, four.nodes[v].position);
    }
    EXPECT_EQ(one.triangles, four.triangles);
}

TEST(KernelPoint, IsNotFoundInAFoldedHull) {
    // A cube whose corner is pushed through the opposite one.
    CellHull hull;
    for (int k = 0; k < 8; ++k) hull.points.emplace_back(k & 1, k >> 1 & 1, k >> 2);
    hull.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    EXPECT_TRUE(kernel_point(hull).has_value());
    hull.points[7] = Vec3(-1, -1, -1);
    EXPECT_FALSE(kernel_point(hull).has_value());
}

/// Heights that are linear on the boundary are so inside: the nodes of plane faces return to them.
TEST(SmoothHeights, PutNodesBackIntoPlaneFaces) {
    const testing::SpaceCase c{"", Lattice::box(1, 1, 1),
                               uniform_points(Lattice::box(1, 1, 1), 9, 4)};
    const CellComplex complex = testing::complex_of(c);
    const GrainSurface surface = surface_of(complex);
    GrainSurface moved = surface;
    std::vector<int> faces;
    for (int f = 0; f < complex.n_faces(); f += 2) faces.push_back(f);
    int n_moved = 0;
    for (SurfaceNode& node : moved.nodes) {
        if (node.dimension != 2) continue;
        node.position += 0.01 * face_plane(complex, node.carrier).normal;
        n_moved += node.carrier % 2 == 0 ? 1 : 0;
    }
    smooth_heights(complex, faces, moved);
    for (std::size_t v = 0; v < moved.nodes.size(); ++v) {
        const SurfaceNode& node = moved.nodes[v];
        const double apart = distance(node.position, surface.nodes[v].position);
        EXPECT_NEAR(apart, node.dimension == 2 && node.carrier % 2 == 1 ? 0.01 : 0, 1e-12);
    }
    EXPECT_GT(n_moved, 10);
}

/// A thin prism over an L, whose arms are seen from their common corner only.
TEST(KernelPoint, IsFoundInAThinCell) {
    const std::vector<Vec3> corners{{0, 0, 0}, {5, 0, 0}, {5, 1, 0},
                                    {1, 1, 0}, {1, 5, 0}, {0, 5, 0}};
    const int n = static_cast<int>(corners.size());
    for (const double thickness : {0.1, 1e-3, 1e-5}) {
        CellHull hull;
        for (const double z : {0.0, thickness}) {
            for (const Vec3& corner : corners) hull.points.emplace_back(corner + Vec3(0, 0, z));
        }
        for (int k = 0; k < n; ++k) {
            const int next = (k + 1) % n;
            hull.triangles.insert(hull.triangles.end(),
                                  {{k, next, next + n}, {k, next + n, k + n}});
            if (k < 1 || next == 0) continue;
            hull.triangles.insert(hull.triangles.end(), {{0, next, k}, {n, k + n, next + n}});
        }
        const std::optional<Vec3> point = kernel_point(hull);
        ASSERT_TRUE(point.has_value()) << thickness;
        for (const auto& [a, b, c] : hull.triangles) {
            EXPECT_GT(volume6(*point, hull.points[a], hull.points[b], hull.points[c]), 0);
        }
    }
}

/// Sides of a box that pass through square faces of truncated octahedra up to 0.001 leave wedges
/// that share two short edges with a face beside them.
TEST(KernelPoint, IsFoundInAllPiecesOfABox) {
    const Lattice cube = Lattice::box(1, 1, 1);
    for (const auto& [seed, moved, corner] : {std::tuple(3, 1e-3, 1), std::tuple(22, 5e-4, 2)}) {
        Points points = moved * uniform_points(cube, 16, static_cast<std::uint64_t>(seed));
        for (int k = 0; k < 16; ++k) {
            const int m = k / 2;
            points.col(k) += Vec3(m & 1, m >> 1 & 1, m >> 2) / 2 + Vec3::Constant(k % 2 / 4.0);
        }
        const Sites sites(cube, points);
        const CellComplex cells = testing::complex_of({"", cube, points});
        const CellComplex pieces =
            cells_in_box(sites, cells, cells.vertices[corner], kSnappedVertices);
        Workers workers(1);
        const std::vector<double> sizes = cell_sizes(pieces, 0.7 * sites.spacing()).sizes;
        for (const CellHull& hull : cell_hulls(pieces, grain_surface(pieces, sizes, workers))) {
            EXPECT_TRUE(kernel_point(hull).has_value());
        }
    }
}

}  // namespace
}  // namespace pcvt::space
