#include "mesher/cvt.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesher/energy.hpp"
#include "mesher/error.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt {
namespace {

using testing::lattices;

CvtResult run(const Lattice& lattice, int n, std::uint64_t seed, const CvtOptions& options) {
    return compute_cvt(lattice, uniform_points(lattice, n, seed), options);
}

CvtOptions to_tolerance(double tolerance) {
    CvtOptions options;
    options.tolerance = tolerance;
    return options;
}

/// The lowest energy over 20 random starts in the unit square.
double best_of_twenty(int n) {
    const Lattice unit = Lattice::rectangle(1, 1);
    double best = 1;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const CvtResult result = run(unit, n, seed, to_tolerance(1e-8));
        EXPECT_EQ(result.stop, Stop::kConverged);
        EXPECT_GE(result.energy, result.energy_bound);
        best = std::min(best, result.energy);
    }
    return best;
}

// Table I of the paper.
TEST(Cvt, ReachesThePapersEnergies) {
    EXPECT_NEAR(best_of_twenty(3) / 5.967078e-2, 1, 1e-6);
    EXPECT_NEAR(best_of_twenty(30) / 5.348148e-3, 1, 1e-6);
}

TEST(Cvt, ConvergesFromOneSiteOnOnEveryLattice) {
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {1, 2, 3, 4, 5, 7, 8, 30, 150}) {
            const CvtResult result = run(lattice, n, 0, to_tolerance(1e-7));
            EXPECT_EQ(result.stop, Stop::kConverged) << name << " n = " << n;
            EXPECT_LE(result.residual, 1e-7);
            EXPECT_GE(result.energy, result.energy_bound * (1 - 1e-12)) << name << " n = " << n;
        }
    }
}

TEST(Cvt, TheResultIsWhatItSays) {
    const Lattice lattice({1, 0}, {0.37, 0.81});
    const CvtResult result = run(lattice, 40, 1, to_tolerance(1e-9));
    const Energy state = energy(result.delaunay);
    EXPECT_NEAR(state.value / result.energy, 1, 1e-14);
    const auto step = state.gradient.array().rowwise() / (2 * state.mass.transpose().array());
    EXPECT_LE(std::sqrt(step.square().colwise().sum().maxCoeff()),
              1e-9 * result.delaunay.sites().spacing() * (1 + 1e-3));
}

TEST(Cvt, ZeroIterationsKeepTheSitesAsGiven) {
    const Lattice unit = Lattice::rectangle(1, 1);
    const Points points = uniform_points(unit, 25, 2);
    CvtOptions options;
    options.max_iterations = 0;
    const CvtResult result = compute_cvt(unit, points, options);
    EXPECT_EQ(result.stop, Stop::kIterationLimit);
    for (SiteId s = 0; s < 25; ++s) {
        EXPECT_LT((result.delaunay.sites().position(s) - points.col(s)).norm(), 0x1p-51);
    }
}

/// Evaluations to an RMS residual of 1e-6 at n = 1000 in the unit square.
int evaluations_to_rms(Solver solver, std::uint64_t seed) {
    int evaluations = 0;
    CvtOptions options = to_tolerance(0);
    options.solver = solver;
    options.progress = [&](const Progress& p) {
        evaluations = p.evaluations;
        return p.rms_residual > 1e-6;
    };
    EXPECT_EQ(run(Lattice::rectangle(1, 1), 1000, seed, options).stop, Stop::kCancelled);
    return evaluations;
}

TEST(SlowCvt, LbfgsNeedsFewEvaluationsAndLloydMany) {
    std::vector<int> evaluations;
    for (std::uint64_t seed = 0; seed < 9; ++seed) {
        evaluations.push_back(evaluations_to_rms(Solver::kLbfgs, seed));
    }
    std::sort(evaluations.begin(), evaluations.end());
    RecordProperty("lbfgs_median", evaluations[4]);
    EXPECT_LE(evaluations[4], 350);
    const int lloyd = evaluations_to_rms(Solver::kLloyd, 0);
    RecordProperty("lloyd", lloyd);
    EXPECT_GT(lloyd, 2000);
}

TEST(Cvt, LloydNeverRaisesTheEnergy) {
    double previous = 1e300;
    CvtOptions options = to_tolerance(1e-5);
    options.solver = Solver::kLloyd;
    options.progress = [&](const Progress& p) {
        EXPECT_LE(p.value, previous * (1 + 1e-14));
        previous = p.value;
        return true;
    };
    EXPECT_EQ(run(Lattice::rectangle(20, 1), 60, 1, options).stop, Stop::kConverged);
}

TEST(Cvt, TheUnitOfLengthDoesNotMatter) {
    const CvtResult one = run(Lattice::rectangle(1, 1), 60, 4, to_tolerance(1e-8));
    for (const double scale : {0x1p-190, 0x1p-20, 0x1p190}) {
        const CvtResult scaled = run(Lattice::rectangle(scale, scale), 60, 4, to_tolerance(1e-8));
        EXPECT_EQ(scaled.stop, Stop::kConverged);
        EXPECT_EQ(scaled.evaluations, one.evaluations);
        EXPECT_EQ(scaled.delaunay.sites().coordinates(), one.delaunay.sites().coordinates());
        EXPECT_DOUBLE_EQ(scaled.energy / scaled.energy_bound, one.energy / one.energy_bound);
    }
}

TEST(Cvt, RefusesSitesThatAlmostCoincide) {
    const Lattice lattice({1, 0}, {7, 1});
    Points points = uniform_points(lattice, 9, 5);
    points.col(6) = points.col(2) + lattice.translation({1, -2}) + Vec2(1e-11, 0);
    try {
        compute_cvt(lattice, points, {});
        FAIL() << "accepted";
    } catch (const DuplicateSites& error) {
        EXPECT_EQ(error.first(), 2);
        EXPECT_EQ(error.second(), 6);
    }
}

TEST(Cvt, TheSameInputGivesTheSameBits) {
    const Lattice lattice({0.5, 0.1}, {-0.2, 2});
    const CvtResult first = run(lattice, 80, 3, to_tolerance(1e-7));
    const CvtResult second = run(lattice, 80, 3, to_tolerance(1e-7));
    EXPECT_EQ(first.delaunay.sites().coordinates(), second.delaunay.sites().coordinates());
    EXPECT_EQ(first.evaluations, second.evaluations);
}

}  // namespace
}  // namespace pcvt
