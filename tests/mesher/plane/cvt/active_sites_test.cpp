#include "mesher/plane/cvt/active_sites.hpp"

#include <gtest/gtest.h>

#include "mesher/cvt/residuals.hpp"
#include "mesher/plane/cvt/coarse_start.hpp"
#include "mesher/plane/energy/energy.hpp"
#include "mesher/plane/mesh/voronoi.hpp"

namespace pcvt::plane {
namespace {

const Lattice& oblique() {
    static const Lattice lattice({1.1, 0}, {0.3, 0.9});
    return lattice;
}

/// The least number of sites with which rounds take place.
constexpr int kSites = 20'000;
/// One that these runs reach soon after their first round.
constexpr double kTolerance = 1e-3;

/// Admits all positions; runs with a guard have no rounds.
class OpenGuard final : public SiteGuard<MovingDelaunay> {
   public:
    bool admits(const MovingDelaunay& /*moving*/) override { return true; }
};

const Points& start() {
    static const Points points = coarse_start(oblique(), kSites, 4, {});
    return points;
}

CvtOptions options_with(int n_threads, double tolerance = kTolerance) {
    CvtOptions options;
    options.run.tolerance = tolerance;
    options.run.n_threads = n_threads;
    options.precondition_below = kPreconditionAfterCoarse;
    options.relaxes_active_sites = true;
    return options;
}

CvtResult solve(const CvtOptions& options) { return compute_cvt(oblique(), start(), options); }

/// The largest |x_i - g_i| / h of the sites that are not fixed, from the polygons of a new
/// triangulation.
double residual_by_polygons(const Sites& sites, const std::vector<bool>& is_fixed = {}) {
    const PeriodicMesh cells = cell_mesh(PeriodicDelaunay(sites));
    double largest = 0;
    for (int f = 0; f < cells.n_faces(); ++f) {
        if (!is_fixed.empty() && is_fixed[cells.site[f]]) continue;
        const Vec2 x = sites.position(cells.site[f]);
        double mass = 0;
        Vec2 first = Vec2::Zero();
        for (int c = cells.face_begin[f]; c < cells.face_begin[f + 1]; ++c) {
            const auto corner = [&](int k) -> Vec2 {
                return cells.vertices[cells.corner_vertex[k]] +
                       cells.lattice.translation(cells.corner_offset[k]) - x;
            };
            const Vec2 p = corner(c);
            const Vec2 q = corner(cells.next(c));
            const double cross = p.x() * q.y() - p.y() * q.x();
            mass += cross / 2;
            first += cross / 6 * (p + q);
        }
        largest = std::max(largest, first.norm() / mass / sites.spacing());
    }
    return largest;
}

TEST(ActiveSites, ReportTheResidualOfAllSites) {
    const CvtResult result = solve(options_with(2));
    EXPECT_EQ(result.run.stop, Stop::kConverged);
    EXPECT_LE(result.run.residual, kTolerance);
    EXPECT_NEAR(residual_by_polygons(result.delaunay.sites()), result.run.residual, 1e-9);
}

TEST(ActiveSites, NeedFewerIterationsThanARunWithoutRounds) {
    OpenGuard guard;
    CvtOptions without = options_with(2);
    without.guard = &guard;
    const CvtResult all_sites = solve(without);
    const CvtResult active = solve(options_with(2));
    EXPECT_GT(all_sites.run.iterations, 115);
    EXPECT_LT(active.run.iterations, all_sites.run.iterations - 5);
    EXPECT_LT(active.run.energy, all_sites.run.energy * (1 + 6e-5));
}

TEST(ActiveSites, GiveTheSameBitsForAllNumbersOfThreads) {
    const Points one = solve(options_with(1)).delaunay.sites().coordinates();
    for (const int n_threads : {2, 3}) {
        EXPECT_EQ(solve(options_with(n_threads)).delaunay.sites().coordinates(), one);
    }
}

TEST(ActiveSites, NeverRaiseTheEnergyAndCanBeCancelled) {
    CvtOptions options = options_with(2);
    double least = std::numeric_limits<double>::infinity();
    options.run.progress = [&](const Progress& progress) {
        EXPECT_LE(progress.value, least * (1 + 1e-12)) << "iteration " << progress.iteration;
        least = std::min(least, progress.value);
        return progress.iteration < 112;
    };
    const CvtResult result = solve(options);
    EXPECT_EQ(result.run.stop, Stop::kCancelled);
    EXPECT_EQ(result.run.iterations, 112);
}

TEST(ActiveSites, LeaveFixedSitesWhereTheyAre) {
    CvtOptions options = options_with(2);
    std::vector<bool> is_fixed(kSites, false);
    for (SiteId s = 0; s < kSites; s += 97) {
        options.fixed.push_back(s);
        is_fixed[s] = true;
    }
    const CvtResult result = solve(options);
    EXPECT_EQ(result.run.stop, Stop::kConverged);
    const Sites before(oblique(), start());
    const Sites& after = result.delaunay.sites();
    for (const SiteId s : options.fixed) {
        EXPECT_EQ(after.coordinates().col(s), before.coordinates().col(s));
    }
    EXPECT_NEAR(residual_by_polygons(after, is_fixed), result.run.residual, 1e-9);
}

/// Whether a run equals one without rounds.
bool has_no_rounds(const Points& points, CvtOptions options) {
    OpenGuard guard;
    const Points first = compute_cvt(oblique(), points, options).delaunay.sites().coordinates();
    options.guard = &guard;
    return compute_cvt(oblique(), points, options).delaunay.sites().coordinates() == first;
}

TEST(ActiveSites, AreNotUsedForFewSitesNorForOtherTolerances) {
    EXPECT_TRUE(has_no_rounds(coarse_start(oblique(), kSites - 1, 4, {}), options_with(2)));
    CvtOptions tight = options_with(2, 9e-5);
    tight.run.max_iterations = 130;
    EXPECT_TRUE(has_no_rounds(start(), tight));
    EXPECT_TRUE(has_no_rounds(start(), options_with(2, 2e-3)));
    EXPECT_FALSE(has_no_rounds(start(), options_with(2)));
}

/// One round after a single site of a minimum was displaced.
class OneDisplacedSite : public ::testing::Test {
   protected:
    OneDisplacedSite() {
        EXPECT_TRUE(pass_.evaluate(energy_));
        Eigen::VectorXf direction = Eigen::VectorXf::Zero(2 * kSites);
        direction[2 * kDisplaced] = 0.1F * float(delaunay_.spacing());
        EXPECT_TRUE(delaunay_.step(direction, 1, workers_));
        EXPECT_TRUE(pass_.evaluate(energy_));
        delaunay_.settle();
    }

    /// Calls relax() before each of 111 iterations; the last call runs a round.
    bool relax() {
        for (int iteration = 0; iteration < 110; ++iteration) {
            EXPECT_FALSE(active_.relax(energy_.gradient, energy_.mass, kTolerance));
        }
        return active_.relax(energy_.gradient, energy_.mass, kTolerance);
    }

    static constexpr SiteId kDisplaced = 7001;
    MovingDelaunay delaunay_{solve(options_with(2)).delaunay.sites()};
    Workers workers_{2};
    FixedBlocks none_;
    EnergyPass pass_{delaunay_, workers_};
    Energy energy_;
    ActiveSites active_{delaunay_, workers_, none_};
};

TEST_F(OneDisplacedSite, RelaxesWithItsNeighboursOnly) {
    const Points before = delaunay_.coordinates();
    const double value = energy_.value;
    ASSERT_TRUE(relax());
    ASSERT_TRUE(pass_.evaluate(energy_));
    EXPECT_LT(energy_.value, value);
    int n_moved = 0;
    for (SiteId s = 0; s < kSites; ++s) {
        if (delaunay_.coordinates().col(s) == before.col(s)) continue;
        ++n_moved;
        Vec2 way = before.col(s) - before.col(kDisplaced);
        way -= way.array().round().matrix();
        EXPECT_LT(delaunay_.frame().to_position(way).norm(), 16 * delaunay_.spacing());
    }
    EXPECT_GT(n_moved, 200);
    EXPECT_LT(n_moved, 800);
    Workers one(1);
    EXPECT_LT(residuals(energy_.gradient, energy_.mass, delaunay_.spacing(), one).largest,
              kTolerance);
    // The triangulation is that of a new build.
    auto [sites, triangulation] = delaunay_.release();
    EXPECT_NO_THROW(PeriodicDelaunay(std::move(sites), std::move(triangulation)));
}

}  // namespace
}  // namespace pcvt::plane
