#include "mesher/plane/cvt/walled_area_cvt.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <random>

#include "mesher/base/error.hpp"
#include "mesher/cells/target_areas.hpp"
#include "mesher/plane/cvt/cell_areas.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/mesh/walled_mesh.hpp"
#include "mesher/plane/proof/generated_tile.hpp"
#include "mesher/plane/symmetry/walled_sites.hpp"
#include "mesher/plane/tile/build_tile.hpp"
#include "tests/support/case_count.hpp"
#include "tests/support/cvt_options.hpp"

namespace pcvt::plane {
namespace {

using testing::kAllWalls;

constexpr std::array kLaws{"equal", "lognormal:0.42", "gamma:0.3", "given"};

/// One random job.
struct WalledJob {
    Lattice lattice = Lattice::rectangle(1, 1);
    Walls walls = Walls::kY;
    WallCells cells = WallCells::kWhole;
    Points points;
    AreaCvtOptions options;
};

/// Areas of a law, or numbers between 1 and 10.
Eigen::VectorXd target_areas(const char* law, const Lattice& lattice, int n,
                             std::mt19937_64& random) {
    Eigen::VectorXd areas(n);
    if (std::string(law) == "given") {
        for (double& a : areas) a = 1 + double(random() % 1000) / 111;
    } else {
        areas = draw_areas(parse_area_law(law), n, random());
    }
    return scaled_areas(areas, n, lattice.area());
}

/// Some of the points lie near to a wall, and some on one.
Points points_near_walls(const Lattice& lattice, Walls walls, int n, std::mt19937_64& random) {
    Points points = uniform_points(lattice, n, random());
    for (int axis = 0; axis < 2; ++axis) {
        if (!has_walls_across(walls, axis)) continue;
        const double side = side_length(lattice, axis);
        for (int s = 0; s < n; ++s) {
            const double off = side * std::array{0.0, 1e-7, 1e-4, 1e-2}[random() % 4];
            if (random() % 8 == 0) points(axis, s) = random() % 2 == 0 ? off : side - off;
        }
    }
    return points;
}

WalledJob random_job(int k) {
    std::mt19937_64 random(static_cast<std::uint64_t>(k));
    const int n = 1 + static_cast<int>(random() % 60);
    const double ratio = std::array{1.0, 1.7, 0.05, 20.0}[random() % 4];
    WalledJob job{.lattice = Lattice::rectangle(std::sqrt(ratio), 1 / std::sqrt(ratio)),
                  .walls = kAllWalls[random() % 3],
                  .points = {},
                  .options = {}};
    job.options.run.max_iterations = std::array{0, 5, -1}[random() % 3];
    job.options.areas = target_areas(kLaws[random() % 4], job.lattice, n, random);
    job.points = job.options.run.max_iterations == 0
                     ? points_near_walls(job.lattice, job.walls, n, random)
                     : uniform_points(job.lattice, n, random());
    return job;
}

WalledAreaCvt computed(const WalledJob& job) {
    return compute_walled_area_cvt(job.lattice, job.walls, job.cells, job.points, job.options);
}

Polygon polygon_of(const PeriodicMesh& mesh, int f) {
    Polygon polygon;
    for (int c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
        polygon.push_back(mesh.point(c));
    }
    return polygon;
}

/// The cell of a site that half-planes of the sites and of their copies along the periodic
/// direction cut out of the strip or the box; relative to the site.
Polygon brute_cell(const Lattice& lattice, Walls walls, const Points& points,
                   const Eigen::VectorXd& weights, SiteId s) {
    const Vec2 site = points.col(s);
    std::array<double, 2> low{};
    std::array<double, 2> high{};
    std::array<int, 2> copies{};
    for (int axis = 0; axis < 2; ++axis) {
        const double side = side_length(lattice, axis);
        copies[axis] = has_walls_across(walls, axis) ? 0 : 3;
        low[axis] = has_walls_across(walls, axis) ? -site[axis] : -3 * side;
        high[axis] = has_walls_across(walls, axis) ? side - site[axis] : 3 * side;
    }
    Polygon cell{{low[0], low[1]}, {high[0], low[1]}, {high[0], high[1]}, {low[0], high[1]}};
    for (SiteId t = 0; t < points.cols(); ++t) {
        for (int i = -copies[0]; i <= copies[0]; ++i) {
            for (int j = -copies[1]; j <= copies[1]; ++j) {
                if (s == t && i == 0 && j == 0) continue;
                Vec2 d = points.col(t) - site;
                // The nearest copies.
                if (copies[0] > 0) d.x() -= std::round(d.x() / lattice.a().x()) * lattice.a().x();
                if (copies[1] > 0) d.y() -= std::round(d.y() / lattice.b().y()) * lattice.b().y();
                d += lattice.translation({i, j});
                cell = clipped(cell, d, (d.squaredNorm() + weights[s] - weights[t]) / 2);
            }
        }
    }
    return cell;
}

/// Requires that each cell is the brute one; returns the largest relative error of an area.
double compare_with_half_planes(const WalledJob& job, const WalledAreaCvt& result) {
    const Points points = points_between_walls(result.torus.delaunay, result.domain);
    const auto n = static_cast<int>(points.cols());
    const Eigen::VectorXd weights = result.torus.delaunay.weights().head(n);
    const PeriodicMesh cells = part_between_walls(cell_mesh(result.torus.delaunay), result.domain);
    EXPECT_EQ(cells.n_faces(), n);
    const double h = std::sqrt(job.lattice.area() / n);
    double largest = 0;
    for (int f = 0; f < cells.n_faces(); ++f) {
        const SiteId s = cells.site[f];
        const Polygon brute = brute_cell(job.lattice, job.walls, points, weights, s);
        const Polygon cell = polygon_of(cells, f);
        const double wanted = job.options.areas[s];
        largest = std::max(largest, std::abs(polygon_area(brute) - wanted) / wanted);
        // Merged corners move by 1e-9 h.
        EXPECT_NEAR(polygon_area(cell), polygon_area(brute), 1e-8 * h * polygon_perimeter(cell));
        Vec2 between = polygon_centroid(cell) - points.col(s) - polygon_centroid(brute);
        for (int axis = 0; axis < 2; ++axis) {
            if (has_walls_across(job.walls, axis)) continue;
            const double side = side_length(job.lattice, axis);
            between[axis] -= std::round(between[axis] / side) * side;
        }
        EXPECT_LT(between.norm(), 1e-6 * h);
    }
    return largest;
}

// Laws 1 and 2. PCVT_AREA_CASES=10000 in the environment runs as many cases.
/// How far the first n sites lie beyond the walls, in parts of a side: their cells are those of the
/// domain.
double farthest_beyond_walls(const WalledAreaCvt& result) {
    double farthest = 0;
    for (SiteId s = 0; s < result.domain.n_sites; ++s) {
        const Vec2 p = result.torus.delaunay.sites().position(s);
        for (int axis = 0; axis < 2; ++axis) {
            if (!has_walls_across(result.domain.walls, axis)) continue;
            const double part = p[axis] / (2 * side_length(result.domain.lattice, axis));
            const double folded = 2 * (part - std::floor(part));
            farthest = std::max(farthest, std::min(folded - 1, 2 - folded));
        }
    }
    return farthest;
}

TEST(WalledAreaCvt, SlowRandomJobsGiveTheCellsOfHalfPlanesInTheTargetAreas) {
    const int n = testing::case_count("PCVT_AREA_CASES", 200);
    int n_rounding = 0;
    for (int k = 0; k < n; ++k) {
        SCOPED_TRACE("case " + std::to_string(k));
        const WalledJob job = random_job(k);
        const WalledAreaCvt result = computed(job);
        const SizeFigures& areas = result.torus.areas;
        const double bound = std::max(area_tolerance(1), areas.rounding);
        EXPECT_LE(areas.largest_relative_error, bound);
        n_rounding += !areas.converged;
        EXPECT_LE(farthest_beyond_walls(result), 1e-9);
        EXPECT_LE(compare_with_half_planes(job, result), 10 * bound);
        if (job.options.run.max_iterations < 0) {
            EXPECT_EQ(result.torus.run.stop, Stop::kConverged);
        }
    }
    EXPECT_LE(n_rounding, 1 + n / 20);
}

/// The place of a site, in parts of a period, folded at the walls.
std::array<double, 2> folded_place(const Sites& sites, Walls walls, SiteId s) {
    std::array<double, 2> place{};
    const Lattice& reduced = sites.reduction().reduced;
    for (int k = 0; k < 2; ++k) {
        const int axis = (k == 0 ? reduced.a() : reduced.b()).x() != 0 ? 0 : 1;
        const double u = sites.coordinates()(k, s);
        place[axis] = u - std::floor(u);
        if (has_walls_across(walls, axis)) place[axis] = std::min(place[axis], 1 - place[axis]);
    }
    return place;
}

TEST(WalledAreaCvt, ImagesHaveTheSameWeightsToTheLastBit) {
    for (int k = 0; k < 60; ++k) {
        const WalledJob job = random_job(k);
        const WalledAreaCvt result = computed(job);
        const Sites& sites = result.torus.delaunay.sites();
        const Eigen::VectorXd& weights = result.torus.delaunay.weights();
        std::map<std::array<double, 2>, double> by_place;
        for (SiteId s = 0; s < sites.n_sites(); ++s) {
            const auto place = folded_place(sites, job.walls, s);
            EXPECT_EQ(by_place.try_emplace(place, weights[s]).first->second, weights[s]) << k;
        }
        EXPECT_EQ(std::ssize(by_place), result.domain.n_sites) << k;
    }
}

TEST(WalledAreaCvt, SlowHalvesHaveTheirAreasBetweenTheWalls) {
    int n_refused = 0;
    for (int k = 0; k < 60; ++k) {
        SCOPED_TRACE("case " + std::to_string(k));
        WalledJob job = random_job(k);
        if (job.options.run.max_iterations == 0) job.options.run.max_iterations = 3;
        job.cells = WallCells::kHalf;
        try {
            const WalledAreaCvt result = computed(job);
            EXPECT_GT(result.domain.n_on_walls, 0);
            const double bound = std::max(area_tolerance(1), result.torus.areas.rounding);
            EXPECT_LE(compare_with_half_planes(job, result), 10 * bound);
        } catch (const DuplicateSites& error) {
            ADD_FAILURE() << error.what();
        } catch (const InvalidInput&) {
            ++n_refused;
        }
    }
    EXPECT_LT(n_refused, 30);
}

TEST(WalledAreaCvt, EachTileIsProvedAndHasTheAreas) {
    for (const Walls walls : kAllWalls) {
        for (const WallCells cells : {WallCells::kWhole, WallCells::kHalf}) {
            std::mt19937_64 random(7);
            const Lattice lattice = Lattice::rectangle(2, 1);
            WalledJob job{lattice, walls, cells, uniform_points(lattice, 60, 3), {}};
            job.options.areas = target_areas("lognormal:0.42", lattice, 60, random);
            job.options.run.max_iterations = 5;
            const WalledAreaCvt result = computed(job);
            for (const MeshKind kind : {MeshKind::kVoronoi, MeshKind::kGrains}) {
                for (const double short_edges : {0.0, 0.15}) {
                    SCOPED_TRACE(walls_row(walls).word);
                    const BuiltTile built = build_tile(result.torus.delaunay,
                                                       {.kind = kind,
                                                        .short_edges = short_edges,
                                                        .repeat = {walls == Walls::kY ? 2 : 1, 1},
                                                        .walled = result.domain});
                    EXPECT_NO_THROW(verify_generated_tile(built.tile));
                    EXPECT_LE(*built.figures.area_error, 1e-10);
                    Eigen::VectorXd areas = Eigen::VectorXd::Zero(60);
                    for (int f = 0; f < built.tile.n_faces(); ++f) {
                        Polygon polygon;
                        for (const int v : built.tile.faces[f]) {
                            polygon.push_back(built.tile.points[v]);
                        }
                        areas[built.tile.face_site[f]] += polygon_area(polygon);
                    }
                    areas /= built.tile.columns;
                    const Eigen::VectorXd error =
                        (areas - job.options.areas).cwiseQuotient(job.options.areas);
                    EXPECT_LE(error.cwiseAbs().maxCoeff(), 3e-10);
                }
            }
        }
    }
}

// Half cells that are narrower than the edges that are removed.
TEST(WalledAreaCvt, NarrowHalvesKeepTheirSidesWithoutShortEdges) {
    const Lattice lattice = Lattice::rectangle(0.25, 4);
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937_64 random(seed);
        WalledJob job{
            lattice, Walls::kXY, WallCells::kHalf, uniform_points(lattice, 125, seed), {}};
        job.options.areas = target_areas("lognormal:0.42", lattice, 125, random);
        job.options.run.max_iterations = 1;
        const WalledAreaCvt result = computed(job);
        const BuiltTile built =
            build_tile(result.torus.delaunay, {.short_edges = 0.1, .walled = result.domain});
        EXPECT_NO_THROW(verify_generated_tile(built.tile));
        EXPECT_LE(*built.figures.area_error, 1e-10);
    }
}

TEST(WalledAreaCvt, SlowAreasAreMeasuredFromSitesAndWeightsAlone) {
    for (int k = 0; k < 60; ++k) {
        const WalledJob job = random_job(k);
        const WalledAreaCvt result = computed(job);
        const Points points = points_between_walls(result.torus.delaunay, result.domain);
        const Eigen::VectorXd weights = result.torus.delaunay.weights().head(points.cols());
        const CellAreas cells = power_cell_areas(job.lattice, job.walls, points, weights);
        const Eigen::VectorXd error =
            (cells.area - job.options.areas).cwiseQuotient(job.options.areas);
        EXPECT_LE(error.cwiseAbs().maxCoeff(), 2 * std::max(1e-10, result.torus.areas.rounding));
        // A weight changes an area by its sensitivity.
        Eigen::VectorXd heavier = weights;
        const double step = 1e-8 * job.lattice.area();
        heavier[0] += step;
        const CellAreas more = power_cell_areas(job.lattice, job.walls, points, heavier);
        const double change = (more.area[0] - cells.area[0]) / step;
        EXPECT_NEAR(change, cells.sensitivity[0], 1e-3 * (1 + cells.sensitivity[0])) << k;
    }
}

// Law 3.
TEST(WalledAreaCvt, SlowEveryBitIsTheSameForAnyNumberOfThreads) {
    std::mt19937_64 random(1);
    const Lattice lattice = Lattice::rectangle(2, 1);
    WalledJob job{lattice, Walls::kXY, WallCells::kWhole, uniform_points(lattice, 9000, 1), {}};
    job.options.areas = target_areas("gamma:0.3", lattice, 9000, random);
    job.options.run.max_iterations = 1;
    const WalledAreaCvt one = computed(job);
    for (const int n_threads : {2, 4}) {
        job.options.run.n_threads = n_threads;
        const WalledAreaCvt several = computed(job);
        EXPECT_EQ(one.torus.delaunay.weights(), several.torus.delaunay.weights());
        EXPECT_EQ(one.torus.delaunay.sites().coordinates(),
                  several.torus.delaunay.sites().coordinates());
    }
}

TEST(WalledAreaCvt, NumberingByColumnsSortsTheSites) {
    const Lattice box = Lattice::rectangle(1.3, 1);
    const Points points = uniform_points(box, 50, 3);
    AreaCvtOptions options;
    options.areas = Eigen::VectorXd::Constant(50, box.area() / 50);
    options.run.max_iterations = 0;
    options.numbering = Numbering::kByColumns;
    const WalledAreaCvt cvt =
        compute_walled_area_cvt(box, Walls::kY, WallCells::kWhole, points, options);
    EXPECT_TRUE(points_between_walls(cvt.torus.delaunay, cvt.domain)
                    .isApprox(sorted_by_columns(box, points), 1e-12));
}

TEST(WalledAreaCvt, FiguresCountTheWorkOfAllRounds) {
    const Lattice box = Lattice::rectangle(1, 1);
    AreaCvtOptions options;
    options.areas = Eigen::VectorXd::Constant(60, box.area() / 60);
    options.run.max_iterations = 5;
    int n_steps = 0;
    int last = 0;
    options.run.progress = [&](const Progress& progress) {
        n_steps += progress.iteration != last;
        last = progress.iteration;
        return true;
    };
    const WalledAreaCvt cvt = compute_walled_area_cvt(box, Walls::kXY, WallCells::kHalf,
                                                      uniform_points(box, 60, 1), options);
    // A round fits the weights at least once before its first step and once after every step.
    EXPECT_GT(n_steps, 5) << "one round only";
    // Four Newton steps follow each step of the sites; only the last round has two for each.
    EXPECT_GE(cvt.torus.areas.newton_steps, 3 * n_steps);
}

// Cells in narrow boxes touch several walls and hold two corners, of which one may have a site.
TEST(WalledAreaCvt, SlowHalvesInNarrowBoxesShareNoCorner) {
    int n_made = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        const double ratio = 1.0 + static_cast<double>(seed % 10);
        const int n = 8 + static_cast<int>(seed % 40);
        const Lattice box = Lattice::rectangle(1, ratio);
        AreaCvtOptions options;
        options.areas = Eigen::VectorXd::Constant(n, box.area() / n);
        options.run.max_iterations = 1;
        try {
            const WalledAreaCvt cvt = compute_walled_area_cvt(
                box, Walls::kXY, WallCells::kHalf, uniform_points(box, n, seed), options);
            EXPECT_EQ(cvt.torus.delaunay.sites().duplicates().first, -1);
            ++n_made;
        } catch (const InvalidInput& error) {
            EXPECT_EQ(std::string(error.what()).rfind("half cells need rows", 0), 0U)
                << seed << ": " << error.what();
        }
    }
    EXPECT_GT(n_made, 20);
}

TEST(WalledAreaCvt, AreasNeedOneNumberASite) {
    const Lattice lattice = Lattice::rectangle(1, 1);
    WalledJob job{lattice, Walls::kY, WallCells::kWhole, uniform_points(lattice, 5, 1), {}};
    job.options.areas = Eigen::VectorXd::Constant(10, 0.1);
    EXPECT_THROW(computed(job), InvalidInput);
}

}  // namespace
}  // namespace pcvt::plane
