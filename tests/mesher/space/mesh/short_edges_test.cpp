#include "mesher/space/mesh/short_edges.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "mesher/space/mesh/cell_faces.hpp"
#include "mesher/space/mesh/cell_sites.hpp"
#include "mesher/space/mesh/polyhedral_mesh.hpp"
#include "mesher/space/proof/polyhedral_proof.hpp"
#include "tests/support/polyhedra.hpp"

namespace pcvt::space {
namespace {

using testing::complex_of;
using testing::space_cases;
using testing::SpaceCase;

/// The last is far above kLongestShortEdge, so that most removals would fold a cell.
constexpr double kShortest[] = {1e-4, 1e-2, 0.1, 0.6};

double spacing(const CellComplex& complex) {
    return std::cbrt(complex.reduced.volume() / complex.n_cells);
}

double shortest_edge(const CellComplex& complex) {
    double shortest = std::numeric_limits<double>::infinity();
    for (int f = 0; f < complex.n_faces(); ++f) {
        Vec3 from = complex.position(complex.corners_of(f).back());
        for (const VertexImage& corner : complex.corners_of(f)) {
            const Vec3 to = complex.position(corner);
            shortest = std::min(shortest, (to - from).norm());
            from = to;
        }
    }
    return shortest;
}

/// The distance from a point to the nearest image of a vertex.
double distance_to_vertices(const CellComplex& complex, const Vec3& point) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec3& vertex : complex.vertices) {
        const Vec3 apart = complex.reduced.to_lattice(point - vertex);
        const Vec3 wrapped = apart.array() - apart.array().round();
        for (int k = 0; k < 27; ++k) {
            const Vec3 image = wrapped + Vec3(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
            nearest = std::min(nearest, complex.reduced.to_position(image).norm());
        }
    }
    return nearest;
}

/// Law (1).
TEST(ShortSpaceEdges, LeaveCellsThatFillTheTorus) {
    int n_removed = 0;
    for (const SpaceCase& c : space_cases()) {
        const CellComplex complex = complex_of(c);
        for (const double shortest : kShortest) {
            SCOPED_TRACE(c.name + ", " + std::to_string(shortest));
            const CellComplex left = without_short_edges(complex, shortest);
            EXPECT_EQ(left.short_edges, shortest);
            n_removed += static_cast<int>(complex.vertices.size() - left.vertices.size());
            const PolyhedralMesh mesh = polyhedral_mesh(Sites(c.lattice, c.points), left);
            EXPECT_NO_THROW(prove_polyhedra(mesh));
            const std::vector<CellBody> before = cell_bodies(complex);
            const std::vector<CellBody> after = cell_bodies(left);
            for (std::size_t s = 0; s < before.size(); ++s) {
                EXPECT_GE(after[s].volume, 0.5 * before[s].volume);
            }
            std::set<std::tuple<SiteId, SiteId, Offset>> pairs;
            for (const CellFace& face : complex.faces) {
                pairs.emplace(face.cell, face.neighbour, face.offset);
            }
            for (const CellFace& face : left.faces) {
                EXPECT_TRUE(pairs.contains({face.cell, face.neighbour, face.offset}));
            }
        }
    }
    EXPECT_GT(n_removed, 1000);
}

/// Law (2).
TEST(ShortSpaceEdges, AreRemovedUntilNoneMayBe) {
    int n_left = 0;
    for (const SpaceCase& c : space_cases()) {
        const CellComplex complex = complex_of(c);
        for (const double shortest : kShortest) {
            const CellComplex left = without_short_edges(complex, shortest);
            if (shortest > kLongestShortEdge) continue;
            n_left += shortest_edge(left) < shortest * spacing(complex) ? 1 : 0;
            if (shortest != 0.1) continue;
            // A second call may move vertices again that moved in the first, and no others.
            const CellComplex again = without_short_edges(left, shortest / 100);
            EXPECT_LE(left.vertices.size() - again.vertices.size(), left.vertices.size() / 50)
                << c.name;
        }
    }
    EXPECT_LT(n_left, 30);
}

TEST(ShortSpaceEdges, AreAllRemovedWhereTheyAreFarFromEachOther) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const CellComplex complex = complex_of({"", cube, uniform_points(cube, 500, 5)});
    const double shortest = 2e-3;
    ASSERT_LT(shortest_edge(complex), shortest / 10 * spacing(complex));
    const CellComplex left = without_short_edges(complex, shortest);
    EXPECT_GE(shortest_edge(left), shortest * spacing(complex));
    // Only a few: random cells have 6.8 vertices a site.
    EXPECT_LT(left.vertices.size(), complex.vertices.size());
    EXPECT_GT(static_cast<double>(left.vertices.size()),
              0.97 * static_cast<double>(complex.vertices.size()));
}

/// Law (3).
TEST(ShortSpaceEdges, MoveVerticesByAtMostTheirLength) {
    for (const SpaceCase& c : space_cases()) {
        const CellComplex complex = complex_of(c);
        if (complex.n_cells > 30) continue;
        for (const double shortest : kShortest) {
            const CellComplex left = without_short_edges(complex, shortest);
            const double most = shortest * spacing(complex) * (1 + 1e-9);
            for (const Vec3& vertex : complex.vertices) {
                EXPECT_LE(distance_to_vertices(left, vertex), most) << c.name;
            }
            for (const Vec3& vertex : left.vertices) {
                EXPECT_LE(distance_to_vertices(complex, vertex), most) << c.name;
            }
        }
    }
}

/// The area vector and the centre of a face by triangles from the mean of its corners.
std::pair<Vec3, Vec3> area_and_centre(const PolyhedralMesh& mesh, int face) {
    const auto& corners = mesh.faces[face];
    Vec3 mean = Vec3::Zero();
    for (const int v : corners) mean += mesh.points[v] / double(corners.size());
    Vec3 area = Vec3::Zero();
    Vec3 centre = Vec3::Zero();
    double sum = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vec3 p = mesh.points[corners[k]];
        const Vec3 q = mesh.points[corners[(k + 1) % corners.size()]];
        const Vec3 triangle = 0.5 * (q - p).cross(mean - p);
        area += triangle;
        centre += triangle.norm() * (p + q + mean) / 3;
        sum += triangle.norm();
    }
    return {area, centre / sum};
}

TEST(ShortSpaceEdges, LeaveCellsWithTheVolumesOfFiniteVolumeSolvers) {
    const Lattice lattice({1, 0, 0}, {0.37, 0.81, 0}, {0.2, 0.4, 0.9});
    const Sites sites(lattice, uniform_points(lattice, 200, 3));
    const CellComplex whole = complex_of({"", lattice, uniform_points(lattice, 200, 3)});
    const PolyhedralMesh mesh = polyhedral_mesh(sites, without_short_edges(whole, 0.1));
    std::vector<double> volumes(200, 0);
    for (int f = 0; f < mesh.n_faces(); ++f) {
        const auto [area, centre] = area_and_centre(mesh, f);
        volumes[mesh.owner[f]] += area.dot(centre) / 3;
        if (f < mesh.n_inner_faces()) volumes[mesh.neighbour[f]] -= area.dot(centre) / 3;
    }
    double bent = 0;
    double sum = 0;
    const std::vector<CellBody> bodies = cell_bodies(mesh);
    const CellFaces faces_of_cells(mesh);
    for (std::size_t s = 0; s < bodies.size(); ++s) {
        EXPECT_NEAR(bodies[s].volume / volumes[s], 1, 1e-12);
        sum += bodies[s].volume;
        PyramidSum fans(mesh.points[mesh.faces[0][0]]);
        for (const auto& [face, reversed] : faces_of_cells[int(s)]) {
            std::vector<Vec3> corners;
            for (const int v : mesh.faces[face]) corners.push_back(mesh.points[v]);
            fans.add(corners, reversed ? -1 : 1);
        }
        bent = std::max(bent, std::abs(fans.body().volume / bodies[s].volume - 1));
    }
    EXPECT_NEAR(sum / lattice.volume(), 1, 1e-12);
    // Fans from one corner of each face give other volumes.
    EXPECT_GT(bent, 1e-3);
}

double sharpest_corner(const CellComplex& complex) {
    double sharpest = 180;
    for (int f = 0; f < complex.n_faces(); ++f) {
        const auto corners = complex.corners_of(f);
        const std::size_t n = corners.size();
        for (std::size_t k = 0; k < n; ++k) {
            const Vec3 at = complex.position(corners[k]);
            const Vec3 u = complex.position(corners[(k + 1) % n]) - at;
            const Vec3 w = complex.position(corners[(k + n - 1) % n]) - at;
            const double angle = std::atan2(u.cross(w).norm(), u.dot(w));
            sharpest = std::min(sharpest, angle * 180 / M_PI);
        }
    }
    return sharpest;
}

/// Law (4).
TEST(ShortSpaceEdges, MakeNoSharperCornerWithTheRuleForGrains) {
    const Lattice cube = Lattice::box(1, 1, 1);
    int n_wider = 0;
    int n_removed = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        SCOPED_TRACE(seed);
        const CellComplex complex = complex_of({"", cube, uniform_points(cube, 60, seed)});
        for (const double shortest : {1e-3, 0.05, 0.1}) {
            const CellComplex left =
                without_short_edges(complex, shortest, ShrinkRule::kWideCorners);
            const CellComplex middle = without_short_edges(complex, shortest);
            EXPECT_NO_THROW(prove_polyhedra(
                polyhedral_mesh(Sites(cube, uniform_points(cube, 60, seed)), left)));
            EXPECT_GE(sharpest_corner(left), std::min(15.0, sharpest_corner(complex)) - 1e-5);
            n_wider += sharpest_corner(left) > sharpest_corner(middle) ? 1 : 0;
            n_removed += static_cast<int>(complex.vertices.size() - left.vertices.size());
        }
    }
    EXPECT_GT(n_wider, 5);
    EXPECT_GT(n_removed, 100);
}

/// Vertices of six or eight cells that fall apart where sites of a lattice move a little: one edge
/// after the other would leave corners of tiny and of long narrow faces that are ever sharper.
TEST(ShortSpaceEdges, VanishInGroupsWithTheRuleForGrains) {
    const Lattice cube = Lattice::box(1, 1, 1);
    for (const int kind : {0, 1}) {
        for (const double moved : {1e-5, 1e-7}) {
            SCOPED_TRACE(std::to_string(kind) + ", " + std::to_string(moved));
            Points points = 0.5 * uniform_points(cube, kind == 0 ? 8 : 32, 5) * moved;
            for (int k = 0; k < points.cols(); ++k) {
                points.col(k) += Vec3(k & 1, k >> 1 & 1, k >> 2 & 1) / 2;
                // A face-centred lattice.
                const int b = k >> 3;
                if (b > 0) points.col(k) += Vec3(b != 3, b != 2, b != 1) / 4;
            }
            const CellComplex complex = complex_of({"", cube, points});
            ASSERT_LT(shortest_edge(complex), moved);
            const CellComplex left = without_short_edges(complex, 1e-3, ShrinkRule::kWideCorners);
            EXPECT_GE(shortest_edge(left), 1e-3 * spacing(complex));
            EXPECT_GT(sharpest_corner(left), 45);
            EXPECT_NO_THROW(prove_polyhedra(polyhedral_mesh(Sites(cube, points), left)));
        }
    }
}

/// Law (5).
TEST(ShortSpaceEdges, LeaveTheCellsOfClustersOnTheirSides) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Lattice lattice({1, 0, 0}, {-0.28, 1, 0}, {-0.13, -0.33, 1.9});
        const Points cluster = 0.02 * uniform_points(lattice, 30, seed);
        const Sites sites(lattice, cluster);
        for (const double shortest : {0.02, kLongestShortEdge}) {
            const PolyhedralMesh mesh = polyhedral_mesh(
                sites, without_short_edges(complex_of({"", lattice, cluster}), shortest));
            EXPECT_NO_THROW(prove_cell_sites(mesh, sites_in_cells(sites, mesh)))
                << "seed " << seed << ", shortest " << shortest;
        }
    }
}

TEST(ShortSpaceEdges, OfLatticesAreNotShort) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const CellComplex octahedra = complex_of({"", cube, testing::lattice_points(16)});
    const CellComplex left = without_short_edges(octahedra, kLongestShortEdge);
    EXPECT_EQ(left.vertices, octahedra.vertices);
    EXPECT_EQ(left.corners, octahedra.corners);
    EXPECT_EQ(without_short_edges(octahedra, 0).short_edges, 0);
}

}  // namespace
}  // namespace pcvt::space
