#include "mesher/plane/mesh/box_outline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>

#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/mesh/box_origin.hpp"
#include "mesher/plane/mesh/short_edges.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/proof/validate.hpp"
#include "mesher/plane/tile/tile_builder.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/special_sites.hpp"

namespace pcvt::plane {
namespace {

using testing::lattices;

Tile box_tile(const PeriodicMesh& pieces) {
    return make_tile(pieces, std::vector<Offset>(std::size_t(pieces.n_faces())));
}

Polygon face(const PeriodicMesh& mesh, int f) {
    Polygon polygon;
    for (int c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
        polygon.push_back(mesh.point(c));
    }
    return polygon;
}

/// Checks law 1 by the proof behind `pcvt check`, and that each corner lies within the box.
void expect_box(const PeriodicMesh& pieces, const Vec2& origin) {
    const Tile flat = box_tile(pieces);
    const TileProof proof = prove_tile(flat, Precision::kDouble);
    compare_vertex_pairs(flat, proof);
    compare_edge_pairs(flat, proof);
    ASSERT_EQ(proof.n_orbits, pieces.n_vertices());
    for (const Vec2& p : flat.points) {
        const Vec2 u = flat.lattice.to_lattice(p - origin);
        ASSERT_GE(u.minCoeff(), -1e-11);
        ASSERT_LE(u.maxCoeff(), 1 + 1e-11);
    }
    for (const VertexPair& pair : flat.vertex_pairs) {
        ASSERT_LE(std::max(std::abs(pair.offset.i), std::abs(pair.offset.j)), 1);
    }
}

/// Checks law 3 by areas.
void expect_whole_cells(const PeriodicMesh& pieces, const PeriodicMesh& cells) {
    std::vector<double> area(static_cast<std::size_t>(cells.n_faces()), 0);
    for (int f = 0; f < pieces.n_faces(); ++f) {
        area[pieces.site[f]] += polygon_area(face(pieces, f));
    }
    for (int f = 0; f < cells.n_faces(); ++f) {
        const double whole = polygon_area(face(cells, f));
        ASSERT_NEAR(area[cells.site[f]], whole, 1e-7 * cells.lattice.area() / cells.n_faces());
    }
}

void expect_cut(const PeriodicMesh& cells, const Vec2& origin) {
    const BoxCut box = cut_along_box(cells, origin);
    expect_box(box.pieces, origin);
    expect_whole_cells(box.pieces, cells);
}

void expect_cuts(const Sites& sites) {
    const PeriodicMesh cells = cell_mesh(PeriodicDelaunay(sites));
    expect_cut(cells, {0, 0});
    // Cut through a vertex of the diagram, and through a site.
    expect_cut(cells, cells.vertices[0]);
    expect_cut(cells, sites.position(0));
}

TEST(BoxOutline, IsProvedForOneSiteAndMoreOnEveryLattice) {
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {1, 2, 3, 5, 8, 40}) {
            SCOPED_TRACE(name + " n = " + std::to_string(n));
            expect_cuts(Sites(lattice, uniform_points(lattice, n, 1)));
            if (HasFatalFailure()) return;
        }
    }
}

// The special sites have cell edges and vertices on the cut, a vertex at its corner, and sites on
// the seam.
TEST(BoxOutline, IsProvedWhereCellEdgesLieOnTheCut) {
    for (const auto& [name, sites] : testing::special_sites()) {
        SCOPED_TRACE(name);
        expect_cuts(sites);
        if (HasFatalFailure()) return;
    }
}

TEST(BoxOutline, IsProvedAtTheOriginThatTheSearchFinds) {
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {1, 2, 4, 7, 30}) {
            SCOPED_TRACE(name + " n = " + std::to_string(n));
            const Sites sites(lattice, uniform_points(lattice, n, 5));
            const PeriodicMesh cells = cell_mesh(PeriodicDelaunay(sites));
            expect_cut(cells, find_box_origin(cells));
        }
    }
}

TEST(BoxOutline, EdgesNearACornerOfTheBoxAreBentThroughIt) {
    for (const auto& [name, lattice] : lattices()) {
        constexpr int kSites = 40;
        const Sites sites(lattice, uniform_points(lattice, kSites, 2));
        const PeriodicMesh cells = without_short_edges(cell_mesh(PeriodicDelaunay(sites)), 0.1);
        const double h = std::sqrt(lattice.area() / kSites);
        for (int c = 0; c < cells.n_corners(); c += 7) {
            SCOPED_TRACE(name + " edge " + std::to_string(c));
            const Vec2 edge = cells.point(cells.next(c)) - cells.point(c);
            const Vec2 normal = Vec2(-edge.y(), edge.x()).normalized();
            const Vec2 corner = cells.point(c) + 0.5 * edge + 0.004 * h * normal;
            const BoxCut box = cut_along_box(cells, corner, 0.03 * h);
            expect_box(box.pieces, corner);
            if (HasFatalFailure()) return;
            EXPECT_GT(box.shortest_edge, 0.005 * h);
        }
    }
}

/// The cells with each vertex moved by at most `distance` in each coordinate.
PeriodicMesh shaken(PeriodicMesh cells, double distance, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(-distance, distance);
    for (Vec2& p : cells.vertices) p += Vec2(uniform(random), uniform(random));
    return cells;
}

Eigen::VectorXd areas_of(const PeriodicMesh& pieces, int n) {
    Eigen::VectorXd areas = Eigen::VectorXd::Zero(n);
    for (int f = 0; f < pieces.n_faces(); ++f) {
        areas[pieces.site[f]] += polygon_area(face(pieces, f));
    }
    return areas;
}

/// How many vertices a cut has moved, and how many edges it has bent.
int n_moved(const BoxSnaps& snaps) {
    const auto is_moved = [](const OnLines& on) { return on[0] || on[1]; };
    return int(std::count_if(snaps.vertices.begin(), snaps.vertices.end(), is_moved)) +
           int(snaps.bends.size());
}

// A box through a vertex, or through the middle of an edge, of cells that are cut in many ways.
TEST(BoxOutline, ACutAsBeforeChangesAreasContinuously) {
    constexpr int kSites = 60;
    int n_other = 0;
    for (const auto& [name, lattice] : lattices()) {
        const double h = std::sqrt(lattice.area() / kSites);
        const PeriodicMesh cells = without_short_edges(
            cell_mesh(PeriodicDelaunay(Sites(lattice, uniform_points(lattice, kSites, 4)))),
            0.02 * h);
        for (int v = 0; v < 12; ++v) {
            SCOPED_TRACE(name + " vertex " + std::to_string(v));
            const Vec2 edge = cells.point(cells.next(v)) - cells.point(v);
            const Vec2 corner = cells.point(v) + (v % 2) * 0.5 * edge + Vec2(0.004, 0.003) * h;
            const BoxCut cut = cut_along_box(cells, corner, 0.03 * h);
            EXPECT_GT(n_moved(cut.snaps), 0);
            const auto same = cut_along_box_as_before(cells, corner, cut.snaps).value();
            EXPECT_EQ(same.snaps, cut.snaps);
            EXPECT_EQ(same.pieces.vertices, cut.pieces.vertices);
            const Eigen::VectorXd before = areas_of(cut.pieces, kSites);
            for (const double distance : {1e-3, 1e-5, 1e-7}) {
                const PeriodicMesh moved = shaken(cells, distance * h, v);
                const auto again = cut_along_box_as_before(moved, corner, cut.snaps).value();
                EXPECT_EQ(again.snaps, cut.snaps);
                const Eigen::VectorXd areas = areas_of(again.pieces, kSites);
                EXPECT_LE((areas - before).cwiseAbs().maxCoeff(), 60 * distance * h * h);
                n_other += cut_along_box(moved, corner, 0.03 * h).snaps != cut.snaps;
            }
        }
    }
    EXPECT_GT(n_other, 0);
}

// Law 4.
TEST(BoxOutline, MovedVerticesStayOnTheCutLongerThanOthers) {
    const Lattice lattice = Lattice::rectangle(1, 1);
    const PeriodicMesh cells =
        cell_mesh(PeriodicDelaunay(Sites(lattice, uniform_points(lattice, 30, 9))));
    const Vec2 p = cells.vertices[0];
    const auto snaps_at = [&](double distance, const BoxSnaps& earlier) {
        // The vertex lies right of the line x = 0.
        const Vec2 corner = p - Vec2(distance, 0.31);
        return cut_along_box(cells, corner, 1e-3, earlier).snaps;
    };
    const BoxSnaps none = snaps_at(0.5e-3 * 30, {});
    ASSERT_FALSE(none.vertices[0][0]);
    const BoxSnaps on = snaps_at(0.9e-3, {});
    ASSERT_TRUE(on.vertices[0][0]);
    EXPECT_FALSE(snaps_at(1.1e-3, {}).vertices[0][0]);
    EXPECT_TRUE(snaps_at(1.3e-3, on).vertices[0][0]);
    EXPECT_FALSE(snaps_at(1.4e-3, on).vertices[0][0]);
    EXPECT_FALSE(snaps_at(0.4e-3, none).vertices[0][0]);
    EXPECT_TRUE(snaps_at(0.3e-3, none).vertices[0][0]);
}

// In a flat parallelogram, both lines are near a point that is far from their corner.
TEST(BoxOutline, AVertexStaysOnItsLineAlsoWhereAnotherIsNearer) {
    const Lattice flat({1, 0}, {7, 1});
    // 0.0005 from the line u = 0, and 0.001 from v = 0.
    const Vec2 u(0.0005 * flat.b().norm(), 0.001);
    const SnapReach reach{0.002, 0.003, 0};
    const auto lines = [&](const OnLines& earlier) {
        const BoxSnaps snaps{.vertices = {earlier}};
        return BoxSnapper(flat, reach, snaps).lines_near(0, u);
    };
    EXPECT_EQ(lines({false, false}), (OnLines{true, false}));
    EXPECT_EQ(lines({true, false}), (OnLines{true, false}));
    EXPECT_EQ(lines({false, true}), (OnLines{false, true}));
}

TEST(BoxOutline, VerticesThatStayAreNotMoved) {
    constexpr int kSites = 40;
    int n_other = 0;
    for (const auto& [name, lattice] : lattices()) {
        const PeriodicMesh cells =
            cell_mesh(PeriodicDelaunay(Sites(lattice, uniform_points(lattice, kSites, 9))));
        const double snap = 0.03 * std::sqrt(lattice.area() / kSites);
        const std::vector<bool> all(cells.vertices.size(), true);
        const Eigen::VectorXd wanted = areas_of(cells, kSites);
        const auto error = [&](const BoxSnaps& snaps) {
            const BoxCut cut = cut_along_box(cells, {0.1, 0.2}, snap, snaps);
            return ((areas_of(cut.pieces, kSites) - wanted).array() / wanted.array())
                .abs()
                .maxCoeff();
        };
        EXPECT_LT(error({.still = all}), 1e-8) << name;
        n_other += error({}) > 1e-6;
    }
    EXPECT_GT(n_other, 2);
}

TEST(BoxOutline, CutsCellsThatAreNotConvex) {
    const Lattice lattice({1, 0}, {0.37, 0.81});
    std::mt19937_64 random(3);
    for (int k = 0; k < 30; ++k) {
        const Sites sites(lattice, uniform_points(lattice, 25, random()));
        const PeriodicMesh cells = cell_mesh(PeriodicDelaunay(sites));
        const PeriodicMesh bent = without_short_edges(cells, 0.06);
        SCOPED_TRACE(k);
        expect_cut(bent, bent.vertices[k % bent.n_vertices()]);
        expect_cut(bent, find_box_origin(bent));
        if (HasFatalFailure()) return;
    }
}

// The lower side of the cell has two notches, and its upper side has two matching teeth: the cut
// touches the lower tooth while it crosses the higher one.
TEST(BoxOutline, CutsACellWithACornerThatOnlyTouchesTheCut) {
    PeriodicMesh cell{
        Lattice::rectangle(1, 1),
        MeshKind::kVoronoi,
        {{0, 0}, {0.25, 0.2}, {0.5, 0}, {0.75, 0.4}},
        {0, 10},
        {0, 1, 2, 3, 0, 0, 3, 2, 1, 0},
        {{0, 0}, {0, 0}, {0, 0}, {0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 1}, {0, 1}, {0, 1}},
        {},
        {},
        {0},
        {{0.5, 0.7}}};
    link_faces(cell);
    for (const double x : {0.1, 0.25, 0.4, 0.9}) {
        for (const double y : {0.0, 0.2, 0.3, 0.4}) {
            SCOPED_TRACE(std::to_string(x) + " " + std::to_string(y));
            expect_cut(cell, {x, y});
            if (HasFatalFailure()) return;
        }
    }
}

TEST(BoxOutline, IsProvedForRandomSmallInputs) {
    std::mt19937_64 random(8);
    for (int k = 0; k < 100; ++k) {
        const Lattice lattice = testing::random_lattice(random);
        SCOPED_TRACE("input " + std::to_string(k));
        expect_cuts(Sites(lattice, uniform_points(lattice, 1 + k % 12, random())));
        if (HasFatalFailure()) return;
    }
}

// Law 2.
TEST(BoxOutline, SnapsAreReducedWhereTheyWouldCollapseAPiece) {
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> uniform(0, 1);
        const Lattice lattice = Lattice::rectangle(std::pow(8, uniform(random)), 1);
        const int n = 1 + static_cast<int>(seed % 8);
        const Sites sites(lattice, uniform_points(lattice, n, seed));
        const double h = sites.spacing();
        const PeriodicMesh cells =
            without_short_edges(cell_mesh(PeriodicDelaunay(sites)), 0.02 * h);
        ASSERT_NO_THROW(expect_box(cut_along_box(cells, {0, 0}, 0.06 * h).pieces, {0, 0})) << seed;
    }
}

TEST(BoxOutline, OppositeSidesHaveTheSameVertices) {
    const Lattice lattice({1, 0}, {0.3, 0.9});
    const PeriodicMesh cells =
        cell_mesh(PeriodicDelaunay(Sites(lattice, uniform_points(lattice, 50, 2))));
    const Tile flat = box_tile(cut_along_box(cells, {0.1, 0.2}).pieces);
    std::set<std::pair<double, double>> points;
    for (const Vec2& p : flat.points) points.emplace(p.x(), p.y());
    int n_lower = 0;
    int n_left = 0;
    for (const Vec2& p : flat.points) {
        const Vec2 u = lattice.to_lattice(p - Vec2(0.1, 0.2));
        const bool lower = p.y() == 0.2;
        const bool left = std::abs(u.x()) < 1e-12;
        n_lower += lower;
        n_left += left;
        const Vec2 up = p + lattice.translation({0, 1});
        const Vec2 right = p + lattice.translation({1, 0});
        ASSERT_TRUE(!lower || points.contains({up.x(), up.y()}));
        ASSERT_TRUE(!left || u.y() > 0.9999 || points.contains({right.x(), right.y()}));
    }
    EXPECT_GT(n_lower, 8);
    EXPECT_GT(n_left, 8);
}

TEST(BoxOutline, PiecesStoreTheirSiteAndTheSidesOfItsCell) {
    const Lattice unit = Lattice::rectangle(1, 1);
    const Sites sites(unit, uniform_points(unit, 30, 4));
    const PeriodicMesh cells = cell_mesh(PeriodicDelaunay(sites));
    const PeriodicMesh pieces = cut_along_box(cells, {0.05, 0.15}).pieces;
    const std::vector<int> sides = box_tile(pieces).whole_sides;
    ASSERT_GT(pieces.n_faces(), 40);
    std::set<SiteId> known;
    for (int f = 0; f < pieces.n_faces(); ++f) {
        const SiteId site = pieces.site[f];
        known.insert(site);
        EXPECT_EQ(sides[f], cells.face_begin[site + 1] - cells.face_begin[site]);
        const Vec2 u = unit.to_lattice(pieces.site_points[f] - sites.position(site));
        EXPECT_LT((u - u.array().round().matrix()).norm(), 1e-13);
        // No other site is nearer to the centroid of a piece than its own.
        const Vec2 middle = polygon_centroid(face(pieces, f));
        for (int g = 0; g < pieces.n_faces(); ++g) {
            EXPECT_LE((pieces.site_points[f] - middle).norm(),
                      (pieces.site_points[g] - middle).norm() + 1e-12);
        }
    }
    EXPECT_EQ(known.size(), 30U);
}

TEST(BoxOutline, OneSquareCellOnItsOwnCutStaysWhole) {
    const Sites sites = testing::grid_sites(Lattice::rectangle(1, 1), 1, 1, 0.5, 0.5);
    const BoxCut box = cut_along_box(cell_mesh(PeriodicDelaunay(sites)), {0, 0});
    EXPECT_EQ(box.pieces.n_faces(), 1);
    EXPECT_EQ(box.pieces.n_corners(), 4);
    EXPECT_EQ(box.shortest_edge, 1);
}

}  // namespace
}  // namespace pcvt::plane
