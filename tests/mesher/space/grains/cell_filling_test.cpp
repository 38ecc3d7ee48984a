#include "mesher/space/grains/cell_filling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "mesher/base/error.hpp"
#include "mesher/space/box/box_cells.hpp"
#include "mesher/space/grains/cavity.hpp"
#include "mesher/space/grains/flat_tetrahedra.hpp"
#include "mesher/space/grains/tetrahedron_flips.hpp"
#include "mesher/space/grains/vertex_insertion.hpp"
#include "tests/support/polyhedra.hpp"

namespace pcvt::space {
namespace {

constexpr int kCells = 12;

double spacing() { return std::cbrt(1.0 / kCells); }

/// The hulls of random cells of the unit cube.
std::vector<CellHull> random_hulls(std::uint64_t seed) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const CellComplex complex =
        testing::complex_of({"random", cube, uniform_points(cube, kCells, seed)});
    Workers workers(1);
    return cell_hulls(complex,
                      grain_surface(complex, std::vector<double>(kCells, spacing() / 3), workers));
}

double hull_volume(const CellHull& hull) {
    double volume = 0;
    for (const auto& [a, b, c] : hull.triangles) {
        volume += volume6(Vec3::Zero(), hull.points[a], hull.points[b], hull.points[c]) / 6;
    }
    return volume;
}

ThreeCorners by_number(ThreeCorners triangle) {
    std::sort(triangle.begin(), triangle.end());
    return triangle;
}

/// The laws of CellTetrahedra.
void expect_filled(const CellHull& hull, const CellTetrahedra& cell) {
    double volume = 0;
    std::set<ThreeCorners> outside;
    for (int t = 0; t < cell.n_numbers(); ++t) {
        if (!cell.is_alive(t)) continue;
        const FourCorners& c = cell.corners(t);
        const double part =
            volume6(cell.point(c[0]), cell.point(c[1]), cell.point(c[2]), cell.point(c[3])) / 6;
        EXPECT_GT(part, 0);
        volume += part;
        EXPECT_GT(cell.quality(t), 0);
        for (int k = 0; k < 4; ++k) {
            const int o = cell.neighbour(t, k);
            if (o < 0) {
                EXPECT_TRUE(outside.insert(by_number(cell.triangle(t, k))).second);
                continue;
            }
            ASSERT_TRUE(cell.is_alive(o));
            bool is_mutual = false;
            for (int m = 0; m < 4; ++m) {
                is_mutual |= cell.neighbour(o, m) == t &&
                             by_number(cell.triangle(o, m)) == by_number(cell.triangle(t, k));
            }
            EXPECT_TRUE(is_mutual);
        }
    }
    std::set<ThreeCorners> expected;
    for (const ThreeCorners& triangle : hull.triangles) expected.insert(by_number(triangle));
    EXPECT_EQ(outside, expected);
    EXPECT_NEAR(volume, hull_volume(hull), 1e-12);
    EXPECT_TRUE(
        std::all_of(cell.marks().begin(), cell.marks().end(), [](char mark) { return mark == 0; }));
}

CellTetrahedra star_of(const CellHull& hull) { return {hull, *kernel_point(hull)}; }

TEST(CellTetrahedra, StarAndRefinementsFillTheHull) {
    for (const CellHull& hull : random_hulls(1)) {
        CellTetrahedra cell = star_of(hull);
        expect_filled(hull, cell);
        const RefinementChoices choices{.size = spacing() / 3};
        insert_lattice(cell, choices, *kernel_point(hull));
        expect_filled(hull, cell);
        refine(cell, choices);
        expect_filled(hull, cell);
        EXPECT_GT(cell.n_vertices(), cell.n_hull() + 1);
    }
}

double flattest(const CellTetrahedra& cell) {
    double least = 1;
    for (int t = 0; t < cell.n_numbers(); ++t) {
        if (cell.is_alive(t)) least = std::min(least, cell.flatness(t));
    }
    return least;
}

/// The law of divide_flat(): the plate that a box cuts off beside a face of a cube.
TEST(DivideFlat, JoinsNoTinyTriangleToAPointFarAway) {
    const Sites site(Lattice::box(1, 1, 1), Points(Vec3(0.5, 0.5, 0.5)));
    const PeriodicDelaunay delaunay = periodic_delaunay(site);
    const CellComplex cube = cell_complex(delaunay.sites, delaunay.tetrahedra);
    const CellComplex pieces = cells_in_box(delaunay.sites, cube, Vec3(1e-4, 0.4, 0.3));
    Workers workers(1);
    const std::vector<CellHull> hulls = cell_hulls(
        pieces, grain_surface(pieces, std::vector<double>(pieces.n_cells, 0.6), workers));
    double least = 1;
    for (const CellHull& hull : hulls) {
        CellTetrahedra cell = star_of(hull);
        refine(cell, {.size = 0.6});
        const double before = flattest(cell);
        least = std::min(least, before);
        divide_flat(cell);
        EXPECT_GE(flattest(cell), before);
        EXPECT_GT(flattest(cell), 2e-9);
        expect_filled(hull, cell);
    }
    EXPECT_LT(least, 1e-9);
}

/// Flips would make tetrahedra that overlap.
TEST(FillCell, RefusesATriangleWithoutAnArea) {
    CellHull hull = random_hulls(3).front();
    const auto [a, b, c] = hull.triangles.front();
    hull.points[c] = (hull.points[a] + hull.points[b]) / 2;
    EXPECT_FALSE(fill_cell(hull, spacing() / 3).has_value());
}

TEST(CellTetrahedra, LocateFindsTheTetrahedronThatHoldsAPoint) {
    const CellHull hull = random_hulls(2).front();
    CellTetrahedra cell = star_of(hull);
    refine(cell, {.size = spacing() / 3});
    for (int t = 0; t < cell.n_numbers(); ++t) {
        if (!cell.is_alive(t)) continue;
        EXPECT_EQ(cell.locate(cell.barycentre(t), cell.any()), t);
    }
    EXPECT_EQ(cell.locate({100, 0, 0}, cell.any()), -1);
}

TEST(CellTetrahedra, RefusesReplacementsWithAnotherBoundary) {
    const CellHull hull = random_hulls(2).front();
    CellTetrahedra cell = star_of(hull);
    std::array<FourCorners, 1> others{cell.corners(0)};
    others[0][3] = others[0][2];
    EXPECT_THROW(cell.replace(std::array{0}, others), InternalError);
}

/// Laws (1) and (2) of Cavity.
TEST(Cavity, KeepsTheHullAndTheVertices) {
    for (const CellHull& hull : random_hulls(3)) {
        CellTetrahedra cell = star_of(hull);
        Cavity cavity(cell);
        int n_inserted = 0;
        for (int t = 0; t < cell.n_numbers() && n_inserted < 20; ++t) {
            if (!cell.is_alive(t) || !cavity.find(cell.barycentre(t), t)) continue;
            cavity.fill(1);
            ++n_inserted;
            expect_filled(hull, cell);
        }
        EXPECT_GT(n_inserted, 5);
        for (int v = cell.n_hull(); v < cell.n_vertices(); ++v) EXPECT_TRUE(cell.is_used(v));
    }
}

/// In a plate spheres hold most tetrahedra, and large cavities lose many unseen ones.
TEST(Cavity, KeepsTheHullOfAPlate) {
    const Lattice flat = Lattice::box(0.03, 1, 1);
    const CellComplex complex = testing::complex_of({"plate", flat, uniform_points(flat, 1, 5)});
    Workers workers(1);
    const CellHull hull = cell_hulls(complex, grain_surface(complex, {0.08}, workers)).front();
    CellTetrahedra cell = star_of(hull);
    ASSERT_GT(cell.n_numbers(), 500);
    Cavity cavity(cell);
    int n_inserted = 0;
    std::size_t most_fresh = 0;
    for (int t = 0; t < cell.n_numbers() && n_inserted < 40; ++t) {
        if (!cell.is_alive(t) || !cavity.find(cell.barycentre(t), t)) continue;
        cavity.fill(1);
        most_fresh = std::max(most_fresh, cell.fresh().size());
        ++n_inserted;
    }
    EXPECT_EQ(n_inserted, 40);
    EXPECT_GT(most_fresh, 100);
    expect_filled(hull, cell);
}

TEST(Cavity, IsNotFoundAtAVertex) {
    const CellHull hull = random_hulls(3).front();
    CellTetrahedra cell = star_of(hull);
    Cavity cavity(cell);
    EXPECT_FALSE(cavity.find(cell.point(cell.corners(0)[0]), 0));
    EXPECT_FALSE(cavity.find(cell.point(cell.corners(0)[1]), 0));
    expect_filled(hull, cell);
}

TEST(TetrahedronFlips, RaiseTheSmallestSine) {
    int n_flips = 0;
    for (const CellHull& hull : random_hulls(4)) {
        CellTetrahedra cell = star_of(hull);
        refine(cell, {.size = spacing() / 3});
        TetrahedronFlips flips(cell);
        for (int t = 0; t < cell.n_numbers(); ++t) {
            if (!cell.is_alive(t)) continue;
            const double before = cell.quality(t);
            if (!flips.flip_at(t)) continue;
            ++n_flips;
            for (const int fresh : cell.fresh()) EXPECT_GT(cell.quality(fresh), before - 1);
            double least = 1;
            for (const int fresh : cell.fresh()) least = std::min(least, cell.quality(fresh));
            EXPECT_GT(least, 0);
        }
        expect_filled(hull, cell);
    }
    EXPECT_GT(n_flips, 50);
}

TEST(VertexMoves, NeverLowerTheSmallestSineOfAStar) {
    for (const CellHull& hull : random_hulls(5)) {
        CellTetrahedra cell = star_of(hull);
        refine(cell, {.size = spacing() / 3});
        VertexMoves moves(cell);
        std::vector<int> star;
        int n_moved = 0;
        for (int v = cell.n_hull(); v < cell.n_vertices(); ++v) {
            cell.find_star(v, star);
            const auto worst = [&] {
                double least = 1;
                for (const int t : star) least = std::min(least, cell.quality(t));
                return least;
            };
            const double before = worst();
            const bool moved = moves.climb(v, kTargetSine);
            EXPECT_EQ(worst() > before, moved);
            EXPECT_GE(worst(), before);
            n_moved += moved ? 1 : 0;
        }
        EXPECT_GT(n_moved, 0);
        expect_filled(hull, cell);
    }
}

TEST(VertexInsertion, FailedInsertionsLeaveTheCellAsItWas) {
    int n_mended = 0;
    std::vector<CellHull> hulls = random_hulls(6);
    hulls.resize(4);
    for (const CellHull& hull : hulls) {
        CellTetrahedra cell = star_of(hull);
        refine(cell, {.size = spacing() / 3});
        VertexMoves moves(cell);
        VertexInsertion insertion(cell, moves);
        const auto state = [&] {
            std::vector<FourCorners> all;
            for (int t = 0; t < cell.n_numbers(); ++t) {
                all.push_back(cell.is_alive(t) ? cell.corners(t) : FourCorners{});
            }
            return all;
        };
        std::vector<FourCorners> before = state();
        for (int t = 0; t < cell.n_numbers(); ++t) {
            if (!cell.is_alive(t) || cell.quality(t) > kTargetSine) continue;
            const int n_vertices = cell.n_vertices();
            const double worst = cell.worst();
            if (insertion.mend(t)) {
                ++n_mended;
                EXPECT_GE(cell.worst(), worst);
                before = state();
                continue;
            }
            ASSERT_EQ(state(), before);
            ASSERT_EQ(cell.n_vertices(), n_vertices);
        }
        expect_filled(hull, cell);
    }
    EXPECT_GT(n_mended, 5);
}

TEST(FillCell, FillsRandomCellsWell) {
    for (const std::uint64_t seed : {7, 8}) {
        for (const CellHull& hull : random_hulls(seed)) {
            const std::optional<CellTetrahedra> cell = fill_cell(hull, spacing() / 3);
            ASSERT_TRUE(cell.has_value());
            expect_filled(hull, *cell);
            // The sine of 5 degrees: some of these cells have sharper corners.
            EXPECT_GT(cell->worst(), 0.087);
        }
    }
}

}  // namespace
}  // namespace pcvt::space
