/// Jobs with prescribed areas and with elongated cells: every tile of them is proved, and their
/// cells are compared with brute force.

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "io/run_files/site_reader.hpp"
#include "mesher/plane/geometry/domain.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/grains/grains.hpp"
#include "plugin/job/job.hpp"
#include "plugin/job/job_tiles.hpp"
#include "plugin/job/plane_world.hpp"
#include "plugin/job/run_job.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/random_numbers.hpp"
#include "tests/support/temporary_folder.hpp"

namespace pcvt {
namespace {

using pcvt::testing::TemporaryFolder;
using ::testing::HasSubstr;
using testing::random_number;

/// A number below n.
int below(std::mt19937_64& random, int n) { return static_cast<int>(random() % std::uint64_t(n)); }

/// Sites at random, in clusters, on a line or on a grid.
plane::Points some_sites(std::mt19937_64& random, const plane::Lattice& lattice, int n) {
    plane::Points points = uniform_points(lattice, n, random());
    const int kind = below(random, 4);
    for (int s = 0; s < n; ++s) {
        const double u = (s + 0.5) / n;
        if (kind == 1) points.col(s) *= 0.05;
        if (kind == 2) points.col(s) = lattice.to_position({u, 0.3});
        if (kind == 3) points.col(s) = lattice.to_position({u, double((s * 5) % n) / n});
    }
    return points;
}

TargetSizes some_areas(std::mt19937_64& random, int n) {
    switch (below(random, 4)) {
        case 0:
            return {.law = parse_area_law("equal"), .name = "equal"};
        case 1:
            return {.law = parse_area_law("lognormal:0.42"), .name = "lognormal:0.42"};
        case 2:
            return {.law = parse_area_law("gamma:0.3"), .name = "gamma:0.3"};
        default:
            Eigen::VectorXd areas(n);
            for (double& a : areas) a = 1 + below(random, 20);
            return {.given = areas, .name = "areas.txt"};
    }
}

Job some_job(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    Job job;
    job.seed = seed;
    job.in_plane().lattice = testing::random_lattice(random);
    job.n_sites = 1 + below(random, below(random, 3) == 0 ? 8 : 60);
    job.run.max_iterations = std::array{0, 1, 4}[below(random, 3)];
    if (below(random, 3) == 0)
        job.in_plane().points = some_sites(random, job.in_plane().lattice, job.n_sites);
    const int kind = below(random, 3);
    if (kind != 0) job.sizes = some_areas(random, job.n_sites);
    if (kind != 1) {
        job.aspect = Aspect{.ratio = std::exp(3 * random_number(random) - 1.5),
                            .degrees = 360 * random_number(random)};
    }
    job.tile.repeat.columns = 1 + below(random, 3);
    job.tile.repeat.rows = 1 + below(random, 2);
    job.tile.order = 1 + below(random, 2);
    job.in_plane().origin = {random_number(random) - 0.5, random_number(random) - 0.5};
    job.tile.outline = below(random, 2) == 0 ? plane::Outline::kBox : plane::Outline::kWhole;
    job.tile.finds_origin = job.tile.outline == plane::Outline::kBox && below(random, 2) == 0;
    job.meshes = {plane::MeshKind::kVoronoi, plane::MeshKind::kGrains};
    if (job.tile.outline == plane::Outline::kWhole)
        job.meshes.push_back(plane::MeshKind::kDelaunay);
    if (below(random, 3) == 0) job.tile.short_edges = 0.1 * random_number(random);
    if (below(random, 4) == 0) job.tile.grain_per_edge = 1 + below(random, 2);
    return job;
}

/// Sums of the areas of the faces of each site.
std::vector<double> areas_by_site(const plane::Tile& tile, int n_sites) {
    std::vector<double> areas(static_cast<std::size_t>(n_sites));
    for (int f = 0; f < tile.n_faces(); ++f) {
        plane::Polygon polygon;
        for (const int v : tile.faces[f])
            polygon.push_back(tile.points[v] - tile.points[tile.faces[f][0]]);
        areas[tile.face_site[f]] += plane::polygon_area(polygon);
    }
    return areas;
}

Eigen::VectorXd target_areas(const Job& job) {
    const auto& [law, given, name] = *job.sizes;
    return scaled_areas(given.size() > 0 ? given : draw_areas(law, job.n_sites, job.seed),
                        job.n_sites, job.in_plane().lattice.area());
}

/// Expects that the faces of each site have its area, also without short edges and in a box.
void expect_areas(const Job& job, const plane::BuiltTile& built) {
    const std::vector<double> areas = areas_by_site(built.tile, job.n_sites);
    const Eigen::VectorXd targets = target_areas(job);
    for (int s = 0; s < job.n_sites; ++s) {
        EXPECT_NEAR(areas[s] / (job.tile.repeat.columns * job.tile.repeat.rows) / targets[s], 1,
                    1e-7);
    }
}

/// The tiles of some jobs, all proved.
struct Outcome {
    int n_proved = 0;
    int n_too_thin = 0;
};

Outcome prove_jobs(std::uint64_t first_seed, std::uint64_t end) {
    const JobCallback silent;
    Outcome outcome;
    for (std::uint64_t seed = first_seed; seed < end; ++seed) {
        SCOPED_TRACE(seed);
        const Job job = some_job(seed);
        JobMonitor monitor(silent, job);
        try {
            const Computation<PlaneWorld> computed = compute_job<PlaneWorld>(job, {}).value();
            for (const plane::BuiltTile& built : proved_tiles(job, computed.cells, monitor)) {
                ++outcome.n_proved;
                EXPECT_EQ(built.tile.site_weights.size(), job.sizes ? job.n_sites : 0);
                EXPECT_EQ(built.tile.metric.is_round(), !job.aspect);
                if (job.sizes && built.figures.kind != plane::MeshKind::kDelaunay)
                    expect_areas(job, built);
            }
        } catch (const DuplicateSites&) {
        } catch (const LimitExceeded&) {
            ++outcome.n_too_thin;  // A piece that the box cuts off.
        } catch (const std::exception& fault) {
            ADD_FAILURE() << fault.what();
        }
    }
    return outcome;
}

TEST(JobAreas, EveryTileIsProvedAndHasTheAreas) {
    const Outcome outcome = prove_jobs(0, 25);
    EXPECT_GT(outcome.n_proved, 40);
    EXPECT_LT(outcome.n_too_thin, 5);
}

TEST(JobAreas, SlowEveryTileIsProvedAndHasTheAreas) {
    const Outcome outcome = prove_jobs(25, 300);
    EXPECT_GT(outcome.n_proved, 500);
    EXPECT_LT(outcome.n_too_thin, 25);
}

/// An edge of the cells crosses several sides of a thin box, and passes near a corner of the box.
TEST(JobAreas, EdgesBendAtCornersOfTheBoxOnly) {
    Job job;
    job.seed = 6;
    job.in_plane().lattice = plane::Lattice({0.32141887474073716, 1.4764704141323493},
                                            {-0.81384407912267953, -4.2811419902297212});
    job.n_sites = 28;
    job.run.max_iterations = 4;
    job.aspect = Aspect{.ratio = 3.0534802623573647, .degrees = 171.91731786629538};
    job.tile.repeat.columns = job.tile.repeat.rows = 2;
    job.in_plane().origin = {0.05031412278732561, 0.035091504123978545};
    job.tile.outline = plane::Outline::kBox;
    job.meshes = {plane::MeshKind::kGrains};
    const JobCallback silent;
    JobMonitor monitor(silent, job);
    const Computation<PlaneWorld> computed = compute_job<PlaneWorld>(job, {}).value();
    EXPECT_EQ(proved_tiles(job, computed.cells, monitor).size(), 1);
}

TEST(JobAreas, CellsHaveTheAreasExactly) {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        const Job job = some_job(seed);
        if (!job.sizes) continue;
        std::optional<Computation<PlaneWorld>> computed;
        try {
            computed = compute_job<PlaneWorld>(job, {});
        } catch (const DuplicateSites&) {
            continue;
        }
        EXPECT_TRUE(computed->cells.areas->converged);
        const RunStatistics& run = computed->cells.run;
        EXPECT_EQ(run.stop,
                  run.residual <= job.run.tolerance ? Stop::kConverged : Stop::kIterationLimit);
        const CellTable& table = computed->cells.table();
        const Eigen::VectorXd targets = target_areas(job);
        const double tolerance = std::max(1e-10, computed->cells.areas->rounding);
        for (int s = 0; s < job.n_sites; ++s) {
            // Corners are merged within 1e-9 h.
            EXPECT_NEAR(table.measure[s] / targets[s], 1, 10 * tolerance + 1e-7);
        }
    }
}

/// The power distance of p from the nearest image of each site, in the metric of the cells.
std::vector<double> power_distances(const plane::Tessellation& cells, const plane::Vec2& p) {
    const plane::Sites& sites = cells.delaunay.sites();
    const plane::Lattice& reduced = sites.reduction().reduced;
    const Eigen::VectorXd& weights = cells.delaunay.weights();
    const plane::Metric metric = cells.elongation ? cells.elongation->metric : plane::Metric();
    std::vector<double> distances;
    for (SiteId s = 0; s < sites.n_sites(); ++s) {
        const plane::Vec2 u = reduced.to_lattice(metric.to_round(p) - sites.position(s));
        double least = std::numeric_limits<double>::infinity();
        for (int i = -1; i <= 1; ++i) {
            for (int j = -1; j <= 1; ++j) {
                const plane::Vec2 d(u.x() - std::round(u.x()) + i, u.y() - std::round(u.y()) + j);
                least = std::min(least, reduced.to_position(d).squaredNorm());
            }
        }
        distances.push_back(least - (weights.size() > 0 ? weights[s] : 0));
    }
    return distances;
}

TEST(JobAreas, CellsAreThoseOfBruteForceInTheMetric) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        const Job job = some_job(seed);
        std::optional<Computation<PlaneWorld>> computed;
        try {
            computed = compute_job<PlaneWorld>(job, {});
        } catch (const DuplicateSites&) {
            continue;
        }
        std::mt19937_64 random(seed);
        const plane::PeriodicMesh mesh = computed->cells.mesh(plane::MeshKind::kVoronoi);
        EXPECT_EQ(mesh.lattice.a(), job.in_plane().lattice.a());
        const double rounding = 1e-7 * job.in_plane().lattice.area() / job.n_sites;
        for (int f = 0; f < mesh.n_faces(); ++f) {
            // A corner, which is as far from the sites of its other cells.
            const int n = mesh.face_begin[f + 1] - mesh.face_begin[f];
            const plane::Vec2 p = mesh.point(mesh.face_begin[f] + below(random, n));
            const std::vector<double> distances = power_distances(computed->cells, p);
            const double least = *std::min_element(distances.begin(), distances.end());
            EXPECT_LE(distances[mesh.site[f]], least + rounding);
        }
    }
}

TEST(JobAreas, SitesOfAFileKeepTheirNumbersAndPlaces) {
    Job job;
    job.in_plane().lattice = plane::Lattice({2, 0}, {0.7, 1});
    job.n_sites = 50;
    job.in_plane().points = uniform_points(job.in_plane().lattice, 50, 3);
    job.sizes = TargetSizes{.given = Eigen::VectorXd::LinSpaced(50, 1, 3), .name = "areas.txt"};
    job.aspect = Aspect{.ratio = 2, .degrees = 30};
    job.run.max_iterations = 0;
    const Computation<PlaneWorld> computed = compute_job<PlaneWorld>(job, {}).value();
    const plane::Points sites = wrapped_sites(computed.cells, job.in_plane().origin);
    const plane::Domain domain(job.in_plane().lattice, job.in_plane().origin);
    for (int s = 0; s < 50; ++s) {
        const plane::Vec2 p = job.in_plane().points.col(s);
        const plane::Vec2 inside = p + job.in_plane().lattice.translation(domain.offset_into(p));
        EXPECT_LT((sites.col(s) - inside).norm(), 1e-12);
    }
    const CellTable& table = computed.cells.table();
    EXPECT_NEAR(table.measure[49] / table.measure[0], 3, 1e-8);
}

TEST(JobAreas, SortedAreasOfAFileLieAtRandom) {
    Job job;
    job.n_sites = 400;
    job.sizes = TargetSizes{.given = Eigen::VectorXd::LinSpaced(400, 1, 9), .name = "areas.txt"};
    job.run.max_iterations = 0;
    const plane::Points sites =
        wrapped_sites(compute_job<PlaneWorld>(job, {}).value().cells, job.in_plane().origin);
    // The correlation of x with the number of the site.
    double sum = 0;
    for (int s = 0; s < 400; ++s) sum += (sites(0, s) - 0.5) * (s - 199.5);
    EXPECT_LT(std::abs(sum) / (400 * 0.289 * 115.5), 0.2);
}

TEST(JobAreas, TheResultIsThatOfTheRoundSpace) {
    // Elongated along x, the unit square is the round rectangle 1/2 x 2.
    Job round;
    round.in_plane().lattice = plane::Lattice::rectangle(0.5, 2);
    round.in_plane().points = uniform_points(round.in_plane().lattice, 80, 1);
    Job job;
    job.in_plane().points = round.in_plane().points;
    job.in_plane().points.row(0) *= 2;
    job.in_plane().points.row(1) /= 2;
    job.aspect = Aspect{.ratio = 4, .degrees = 0};
    const Computation<PlaneWorld> here = compute_job<PlaneWorld>(job, {}).value();
    const Computation<PlaneWorld> there = compute_job<PlaneWorld>(round, {}).value();
    EXPECT_EQ(here.cells.run.energy, there.cells.run.energy);
    plane::Points mapped = wrapped_sites(there.cells, plane::Vec2::Zero());
    mapped.row(0) *= 2;
    mapped.row(1) /= 2;
    EXPECT_EQ(wrapped_sites(here.cells, plane::Vec2::Zero()), mapped);
}

TEST(JobAreas, ProgressNamesTheStepsAndRises) {
    for (const int steps : {-1, 0, 3}) {
        Job job;
        job.n_sites = 200;
        job.sizes = TargetSizes{.law = parse_area_law("gamma:0.4"), .name = "gamma:0.4"};
        job.run.max_iterations = steps;
        job.run.tolerance = 1e-3;
        std::string words;
        double fraction = 0;
        compute_job<PlaneWorld>(job, [&](const JobProgress& progress) {
            if (progress.phase != Phase::kOptimising) return true;
            EXPECT_GE(progress.fraction, fraction);
            EXPECT_LE(progress.fraction, 1);
            fraction = progress.fraction;
            words += progress.text + "\n";
            return true;
        });
        EXPECT_THAT(words, HasSubstr("Newton step 1\n"));
        const char* const begin =
            steps < 0 ? "optimising, Newton" : "fitting the areas, Newton step 0\n";
        EXPECT_THAT(words, HasSubstr(begin));
        const char* const later = steps == 3 ? "centroidal step 2 of 3, Newton step 1" : "";
        EXPECT_THAT(words, HasSubstr(later));
        EXPECT_GT(fraction, 0.9);
    }
}

TEST(JobAreas, AnyCallOfTheCallbackCancels) {
    Job job;
    job.n_sites = 100;
    job.sizes = TargetSizes{.law = parse_area_law("gamma:0.4"), .name = "gamma:0.4"};
    job.run.max_iterations = 2;
    for (int last = 0; last < 12; ++last) {
        int n_calls = 0;
        EXPECT_FALSE(
            compute_job<PlaneWorld>(job, [&](const JobProgress&) { return n_calls++ < last; }));
        EXPECT_EQ(n_calls, last + 1);
    }
}

TEST(JobAreas, SitesOfTheReportsAreThoseOfTheFiles) {
    const TemporaryFolder folder;
    Job job;
    job.n_sites = 30;
    job.in_plane().lattice = plane::Lattice({1, 0}, {0.4, 0.9});
    job.aspect = Aspect{.ratio = 3, .degrees = 110};
    job.sizes = TargetSizes{.law = parse_area_law("gamma:0.4"), .name = "gamma:0.4"};
    job.run.max_iterations = 1;
    job.in_plane().origin = {3, -2};
    job.meshes = {plane::MeshKind::kVoronoi, plane::MeshKind::kGrains};
    job.outputs = {folder / "t.svg", folder / "t.txt", folder / "t.csv"};
    job.report = folder / "r.json";
    const RunSummary summary = run_job(job, {});
    EXPECT_LT(summary.sizes->newton.largest_relative_error, 1e-10);
    const plane::Points sites = read_sites<2>({.path = folder / "t.txt"}).points;
    const Computation<PlaneWorld> computed = compute_job<PlaneWorld>(job, {}).value();
    EXPECT_EQ(sites, wrapped_sites(computed.cells, job.in_plane().origin));
}

}  // namespace
}  // namespace pcvt
