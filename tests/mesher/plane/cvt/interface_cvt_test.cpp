#include "mesher/plane/cvt/interface_cvt.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <set>

#include "mesher/plane/interfaces/empty_circles.hpp"
#include "mesher/plane/interfaces/random_circles.hpp"
#include "mesher/plane/mesh/interface_proof.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/mesh/walled_mesh.hpp"
#include "tests/support/case_count.hpp"
#include "tests/support/densities.hpp"
#include "tests/support/energy_at.hpp"
#include "tests/support/example_lattices.hpp"
#include "tests/support/random_inclusions.hpp"

namespace pcvt::plane {
namespace {

using testing::kSquare;

/// The number of cases; more of them, with more sites, if PCVT_INTERFACE_CASES sets it.
int n_cases() { return testing::case_count("PCVT_INTERFACE_CASES", 100); }

InclusionSet random_set(std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    const double lean = 0.8 * unit(random);
    const Lattice lattice({1, 0}, {lean, 0.6 + unit(random)});
    const int n_shapes = 1 + int(30 * unit(random));
    // A fifth of the cases are dense packings of circles.
    if (unit(random) < 0.2) {
        const double fraction = 0.3 + 0.3 * unit(random);
        const auto circles = random_circles(
            lattice, {.fraction = fraction, .n = 8 + n_shapes, .gap = 0.02}, random());
        return {lattice, circular_inclusions(circles, 1)};
    }
    const int n_across = int(5 * unit(random));
    const double fraction = 0.1 + 0.5 * unit(random);
    return {lattice, testing::random_inclusions(lattice, {n_shapes, n_across, fraction}, random)};
}

/// The number in "...; take N".
int suggested_number(const std::string& message) {
    return std::atoi(message.substr(message.rfind(' ') + 1).c_str());
}

/// With the number of sites that a refusal names.
InterfaceCvt compute(const InclusionSet& set, int n, std::uint64_t seed, const CvtOptions& options,
                     WallCells cells = WallCells::kWhole) {
    try {
        return compute_interface_cvt(set, n, seed, options, cells);
    } catch (const InvalidInput& error) {
        EXPECT_THAT(error.what(), ::testing::HasSubstr("sites are too few for the inclusions"));
        return compute_interface_cvt(set, suggested_number(error.what()), seed, options, cells);
    }
}

void expect_laws(const InclusionSet& set, const InterfaceCvt& result) {
    const Sites& sites = result.cvt.delaunay.sites();
    const InterfaceSites& pairs = result.interfaces;
    // Law (1).
    EXPECT_EQ(sites.coordinates().leftCols(pairs.n_seeds()), pairs.coordinates);
    // Law (2).
    const EmptyCircles circles(set.reduction().reduced, pairs.circles);
    const auto n = static_cast<SiteId>(result.inclusion.size());
    for (SiteId s = pairs.n_seeds(); s < n; ++s) {
        EXPECT_FALSE(circles.contain(sites.coordinates().col(s))) << "site " << s;
    }
    // Law (3).
    const auto wrong = interface_violation(cell_mesh(result.cvt.delaunay), pairs, result.inclusion);
    EXPECT_FALSE(wrong) << *wrong;
    for (SiteId s = 0; s < n; ++s) {
        const int i = result.inclusion[s];
        EXPECT_EQ(result.tag[s], i < 0 ? 0 : set[i].tag);
    }
}

TEST(InterfaceCvt, MakesEveryChordAnEdgeSlow) {
    const int cases = n_cases();
    for (int k = 0; k < cases; ++k) {
        std::mt19937_64 random(k);
        std::uniform_real_distribution<double> unit(0, 1);
        const InclusionSet set = random_set(random);
        const int n = int(300 * std::pow(cases > 100 ? 33.3 : 10, unit(random)));
        SCOPED_TRACE("case " + std::to_string(k) + ", n = " + std::to_string(n));
        try {
            const InterfaceCvt result = compute(set, n, std::uint64_t(k), {});
            EXPECT_EQ(result.cvt.run.stop, Stop::kConverged);
            EXPECT_LE(result.held.size(), 0.02 * result.cvt.delaunay.sites().n_sites() + 1);
            expect_laws(set, result);
        } catch (const Error& error) {
            ADD_FAILURE() << error.what();
        }
    }
}

TEST(InterfaceCvt, ShapesInsideOfOthersHaveTheirChordsAndTheirTags) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
        const Lattice lattice({1, 0}, {0.3, 0.9});
        const double x = 0.4 * static_cast<double>(seed);
        const InclusionSet set(
            lattice, {{Circle{{x, 0.1}, 0.15}, 1, 1},
                      {Circle{{x, 0.1}, 0.21}, 2, 2},
                      {Ellipse{{x + 0.5, 0.5}, 0.2, 0.15, 40}, 2, 3},
                      {Polygon{{x + 0.45, 0.45}, {x + 0.55, 0.45}, {x + 0.5, 0.55}}, 3, 4}});
        const InterfaceCvt result = compute(set, 700, seed, {});
        expect_laws(set, result);
        // Each site has the tag of the innermost shape.
        const Sites& sites = result.cvt.delaunay.sites();
        for (SiteId s = 0; s < sites.n_sites(); ++s) {
            const Vec2 p = sites.reduction().reduced.to_position(sites.coordinates().col(s));
            const int k = set.containing(p);
            EXPECT_EQ(result.tag[s], k < 0 ? 0 : set[k].tag) << s;
        }
        std::vector<double> area(4, 0);
        const PeriodicMesh cells = cell_mesh(result.cvt.delaunay);
        for (int f = 0; f < cells.n_faces(); ++f) {
            area[result.tag[f]] += polygon_area(face_polygon(cells, f));
        }
        const double coating = shape_area(set[1].shape) - shape_area(set[0].shape);
        const double triangle = shape_area(set[3].shape);
        EXPECT_NEAR(area[1], shape_area(set[0].shape), 1e-12);
        EXPECT_NEAR(area[2], coating + shape_area(set[2].shape) - triangle, 1e-12);
        EXPECT_NEAR(area[3], triangle, 1e-12);
    }
}

struct CellFigures {
    double least_area = std::numeric_limits<double>::infinity();
    double largest_area = 0;
    /// Energy per bound of the cells of free sites.
    double free_energy = 0;
};

/// Areas in units of h^2.
CellFigures figures_of(const InterfaceCvt& result) {
    const PeriodicMesh cells = cell_mesh(result.cvt.delaunay);
    const double h2 = cells.lattice.area() / cells.n_faces();
    CellFigures figures;
    double energy = 0;
    double area_of_free = 0;
    for (int f = 0; f < cells.n_faces(); ++f) {
        Polygon cell;
        for (int c = cells.face_begin[f]; c < cells.face_begin[f + 1]; ++c) {
            cell.push_back(cells.point(c) - cells.site_points[f]);
        }
        const double area = polygon_area(cell);
        figures.least_area = std::min(figures.least_area, area / h2);
        figures.largest_area = std::max(figures.largest_area, area / h2);
        if (f < result.interfaces.n_seeds()) continue;
        area_of_free += area;
        for (std::size_t k = 0; k < cell.size(); ++k) {
            const Vec2& p = cell[k];
            const Vec2& q = cell[(k + 1) % cell.size()];
            energy += cross(p, q) / 12 * (p.squaredNorm() + p.dot(q) + q.squaredNorm());
        }
    }
    const int n_free = cells.n_faces() - result.interfaces.n_seeds();
    figures.free_energy = energy / hexagonal_bound(area_of_free, n_free);
    return figures;
}

TEST(InterfaceCvt, HasGoodCellsRoundThirtyFibresSlow) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
        const auto fibres = random_circles(kSquare, {.fraction = 0.5, .n = 30}, seed);
        const InclusionSet set(kSquare, circular_inclusions(fibres, 1));
        const InterfaceCvt result = compute_interface_cvt(set, 10'000, seed, {});
        expect_laws(set, result);
        const CellFigures figures = figures_of(result);
        RecordProperty("free_energy", std::to_string(figures.free_energy));
        EXPECT_GT(figures.least_area, 0.4);
        EXPECT_LT(figures.largest_area, 1.6);
        EXPECT_LT(figures.free_energy, 1.06);
        EXPECT_TRUE(result.held.empty());
    }
}

TEST(InterfaceCvt, LeavesFreeSitesAtTheirCentroids) {
    const InclusionSet set(kSquare, {{Circle{{0.95, 0.1}, 0.25}, 1, 1},
                                     {Polygon{{0.3, 0.5}, {0.6, 0.5}, {0.45, 0.8}}, 2, 2}});
    const InterfaceCvt result = compute_interface_cvt(set, 800, 1, {});
    const Sites& sites = result.cvt.delaunay.sites();
    const testing::PlaneEnergy energy = testing::energy_at(sites);
    EXPECT_NEAR(result.cvt.run.energy / energy.value, 1, 1e-12);
    for (SiteId s = result.interfaces.n_seeds(); s < sites.n_sites(); ++s) {
        if (std::find(result.held.begin(), result.held.end(), s) != result.held.end()) continue;
        EXPECT_LT(energy.gradient.col(s).norm() / (2 * energy.mass[s]), 1.01e-6 * sites.spacing());
    }
}

TEST(InterfaceCvt, FollowsADensity) {
    const InclusionSet set(
        kSquare, {{Circle{{0.95, 0.1}, 0.25}, 1, 1}, {Ellipse{{0.4, 0.6}, 0.2, 0.1, 30}, 2, 2}});
    CvtOptions options;
    options.density = testing::smooth_density();
    options.run.tolerance = 1e-4;
    const InterfaceCvt result = compute_interface_cvt(set, 1500, 1, options);
    EXPECT_EQ(result.cvt.run.stop, Stop::kConverged);
    expect_laws(set, result);
    EXPECT_LT(result.cvt.density->spacing_deviation, 0.06);
}

TEST(InterfaceCvt, RunsWithEverySolver) {
    const InclusionSet set(kSquare, {{Circle{{0, 0}, 0.3}, 1, 1}});
    for (const SolverRow& row : kSolvers) {
        CvtOptions options;
        options.run.solver = row.solver;
        options.run.tolerance = 1e-3;
        const InterfaceCvt result = compute_interface_cvt(set, 500, 1, options);
        EXPECT_EQ(result.cvt.run.stop, Stop::kConverged) << row.word;
        expect_laws(set, result);
    }
}

TEST(InterfaceCvt, IsTheSameForAnyNumberOfThreads) {
    const InclusionSet set(kSquare, {{Circle{{0, 0}, 0.3}, 1, 1}});
    CvtOptions options;
    const InterfaceCvt one = compute_interface_cvt(set, 600, 1, options);
    options.run.n_threads = 3;
    const InterfaceCvt other = compute_interface_cvt(set, 600, 1, options);
    EXPECT_EQ(one.cvt.delaunay.sites().coordinates(), other.cvt.delaunay.sites().coordinates());
}

/// Shapes between walls.
InclusionSet random_walled_set(std::mt19937_64& random, Walls walls) {
    std::uniform_real_distribution<double> unit(0, 1);
    const Lattice domain = Lattice::rectangle(0.5 + 1.5 * unit(random), 0.5 + 1.5 * unit(random));
    if (unit(random) < 0.3) {
        const double fraction = 0.1 + 0.3 * unit(random);
        const auto circles =
            random_circles(domain, {.fraction = fraction, .n = 12}, random(), walls);
        return {domain, circular_inclusions(circles, 1), walls};
    }
    const int n_shapes = 1 + int(12 * unit(random));
    const testing::RandomInclusions wanted{.n_shapes = n_shapes, .gap = 0.03, .walls = walls};
    return {domain, testing::random_inclusions(domain, wanted, random), walls};
}

/// The areas of inclusions in the mesh between walls, without the matrix.
std::vector<double> areas_between_walls(const InclusionSet& set, const InterfaceCvt& result) {
    const PeriodicMesh cells = part_between_walls(cell_mesh(result.cvt.delaunay), *result.walled);
    std::vector<double> areas(static_cast<std::size_t>(set.n_given()), 0);
    for (int f = 0; f < cells.n_faces(); ++f) {
        Polygon cell;
        for (int c = cells.face_begin[f]; c < cells.face_begin[f + 1]; ++c) {
            cell.push_back(cells.point(c) - cells.site_points[f]);
        }
        const int i = result.inclusion[cells.site[f]];
        if (i >= 0) areas[i] += polygon_area(cell);
    }
    return areas;
}

void expect_mirror_symmetry(const InclusionSet& set, const InterfaceCvt& result) {
    const Sites& sites = result.cvt.delaunay.sites();
    const Lattice& reduced = sites.reduction().reduced;
    std::set<std::pair<double, double>> places;
    for (const auto& u : sites.coordinates().colwise()) places.emplace(u.x(), u.y());
    for (SiteId s = 0; s < sites.n_sites(); ++s) {
        for (int r = 1; r < n_images(set.walls()); ++r) {
            Vec2 image = sites.coordinates().col(s);
            // The reduced basis lies along the axes.
            for (int k = 0; k < 2; ++k) {
                const Vec2 along = k == 0 ? reduced.a() : reduced.b();
                if (mirror_image(along, set.walls(), r) != along)
                    image[k] = wrap(-image[k]).fraction;
            }
            EXPECT_TRUE(places.contains({image.x(), image.y()})) << "site " << s;
        }
    }
}

TEST(InterfaceCvt, KeepsItsLawsBetweenWallsSlow) {
    for (int k = 0; k < 60; ++k) {
        std::mt19937_64 random(k);
        std::uniform_real_distribution<double> unit(0, 1);
        const Walls walls = kWalls[1 + k % 3].walls;
        const InclusionSet set = random_walled_set(random, walls);
        const int n = int(300 * std::pow(5, unit(random)));
        SCOPED_TRACE("case " + std::to_string(k) + ", n = " + std::to_string(n));
        const InterfaceCvt result = compute(set, n, std::uint64_t(k), {});
        EXPECT_EQ(result.cvt.run.stop, Stop::kConverged);
        EXPECT_GE(result.cvt.run.energy, result.cvt.energy_bound);
        expect_laws(set, result);
        expect_mirror_symmetry(set, result);
        const std::vector<double> areas = areas_between_walls(set, result);
        for (int i = 0; i < set.n_given(); ++i) {
            EXPECT_NEAR(areas[i], shape_area(set[i].shape), 1e-12 * set.domain().area());
        }
    }
}

TEST(InterfaceCvt, SlowHasHalfCellsOrSaysThatAWallIsTooNear) {
    int n_refused = 0;
    for (int k = 0; k < 12; ++k) {
        std::mt19937_64 random(k);
        const Walls walls = kWalls[1 + k % 3].walls;
        const double radius = 0.15 + 0.02 * k;
        const InclusionSet set(Lattice::rectangle(1.5, 1), {{Circle{{0.75, 0.5}, radius}, 1, 1}},
                               walls);
        try {
            CvtOptions options;
            options.run.tolerance = 1e-3;
            const InterfaceCvt result = compute(set, 500, 1, options, WallCells::kHalf);
            expect_laws(set, result);
            EXPECT_GT(result.walled->n_on_walls, 20);
            EXPECT_NEAR(areas_between_walls(set, result)[0], shape_area(set[0].shape), 1.5e-12);
        } catch (const InvalidInput& error) {
            EXPECT_THAT(error.what(), ::testing::HasSubstr("too near to a wall for half cells"));
            ++n_refused;
        }
    }
    EXPECT_LT(n_refused, 4);
}

TEST(InterfaceCvt, TakesPolygonsWithParallelSidesAtAnyAngle) {
    for (int k = 0; k < 200; ++k) {
        const double turn = 0.0173 * k;
        const Vec2 along(std::cos(turn), std::sin(turn));
        const Vec2 up(-along.y(), along.x());
        const Vec2 centre(0.5, 0.5);
        const InclusionSet set(
            kSquare, {{Polygon{centre - 0.2 * along - 0.1 * up, centre + 0.2 * along - 0.1 * up,
                               centre + 0.2 * along + 0.1 * up, centre - 0.2 * along + 0.1 * up},
                       1, 1}});
        CvtOptions options;
        options.run.max_iterations = 0;
        const InterfaceCvt result = compute_interface_cvt(set, 400, 1, options);
        EXPECT_LT(result.interfaces.chords.size(), 80u) << k;
        expect_laws(set, result);
    }
}

TEST(InterfaceCvt, WithoutInclusionsIsACvt) {
    const InterfaceCvt result = compute_interface_cvt(InclusionSet(kSquare, {}), 100, 1, {});
    EXPECT_EQ(result.cvt.run.stop, Stop::kConverged);
    EXPECT_EQ(result.tag, std::vector<int>(100, 0));
}

TEST(InterfaceCvt, EndsWhereItsCallerWantsIt) {
    const InclusionSet set(kSquare, {{Circle{{0, 0}, 0.3}, 1, 1}});
    CvtOptions options;
    options.run.max_iterations = 5;
    const InterfaceCvt limited = compute_interface_cvt(set, 500, 1, options);
    EXPECT_EQ(limited.cvt.run.stop, Stop::kIterationLimit);
    EXPECT_EQ(limited.cvt.run.iterations, 5);
    expect_laws(set, limited);
    options.run.max_iterations = 0;
    expect_laws(set, compute_interface_cvt(set, 500, 1, options));
    options.run.max_iterations = -1;
    options.run.progress = [](const Progress& progress) { return progress.iteration < 7; };
    const InterfaceCvt cancelled = compute_interface_cvt(set, 500, 1, options);
    EXPECT_EQ(cancelled.cvt.run.stop, Stop::kCancelled);
    expect_laws(set, cancelled);
}

TEST(InterfaceCvt, NamesANumberOfSitesThatSuffices) {
    const InclusionSet set(kSquare,
                           {{Circle{{0, 0}, 0.3}, 1, 1}, {Circle{{0.5, 0.5}, 0.39}, 1, 2}});
    for (const int n : {1, 10, 40}) {
        try {
            compute_interface_cvt(set, n, 1, {});
            ADD_FAILURE() << n;
        } catch (const InvalidInput& error) {
            const int enough = suggested_number(error.what());
            EXPECT_GT(enough, n);
            EXPECT_LT(enough, 400);
            expect_laws(set, compute_interface_cvt(set, enough, 1, {}));
        }
    }
    EXPECT_THROW(compute_interface_cvt(set, 0, 1, {}), InvalidInput);
}

}  // namespace
}  // namespace pcvt::plane
