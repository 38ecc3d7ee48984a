#include "mesher/plane/cvt/cvt.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "mesher/base/error.hpp"
#include "tests/support/cvt_options.hpp"
#include "tests/support/energy_at.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/nearest_site.hpp"
#include "tests/support/sublattice.hpp"

namespace pcvt::plane {
namespace {

using testing::lattices;
using testing::to_tolerance;

CvtResult random_cvt(const Lattice& lattice, int n, std::uint64_t seed, const CvtOptions& options) {
    return compute_cvt(lattice, uniform_points(lattice, n, seed), options);
}

/// The lowest energy over 20 random starts in the unit square.
double best_of_twenty(int n) {
    const Lattice unit = Lattice::rectangle(1, 1);
    double best = 1;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const CvtResult result = random_cvt(unit, n, seed, to_tolerance(1e-8));
        EXPECT_EQ(result.run.stop, Stop::kConverged);
        EXPECT_GE(result.run.energy, result.energy_bound);
        best = std::min(best, result.run.energy);
    }
    return best;
}

// Table I of the paper.
TEST(Cvt, ReachesThePapersEnergies) {
    EXPECT_NEAR(best_of_twenty(3) / 5.967078e-2, 1, 1e-6);
    EXPECT_NEAR(best_of_twenty(30) / 5.348148e-3, 1, 1e-6);
}

TEST(Cvt, ConvergesForOneSiteAndMoreOnEveryLattice) {
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {1, 2, 3, 4, 5, 7, 8, 30, 150}) {
            const CvtResult result = random_cvt(lattice, n, 0, to_tolerance(1e-7));
            EXPECT_EQ(result.run.stop, Stop::kConverged) << name << " n = " << n;
            EXPECT_LE(result.run.residual, 1e-7);
            EXPECT_GE(result.run.energy, result.energy_bound * (1 - 1e-12)) << name << " n = " << n;
        }
    }
}

void expect_as_told(const CvtResult& result) {
    const testing::PlaneEnergy state = testing::energy_at(result.delaunay.sites());
    EXPECT_NEAR(state.value / result.run.energy, 1, 1e-13);
    const auto step = state.gradient.array().rowwise() / (2 * state.mass.transpose().array());
    const Eigen::ArrayXd squares = step.square().colwise().sum().transpose();
    const double h = result.delaunay.sites().spacing();
    EXPECT_NEAR(result.run.residual, std::sqrt(squares.maxCoeff()) / h, 1e-12);
    EXPECT_NEAR(result.run.rms_residual, std::sqrt(squares.mean()) / h, 1e-12);
}

TEST(Cvt, TheReportedFiguresAgreeWithAnIndependentEvaluation) {
    const Lattice lattice({1, 0}, {0.37, 0.81});
    CvtOptions options = to_tolerance(1e-9);
    for (const int limit : {0, 1, 7, -1}) {
        options.run.max_iterations = limit;
        expect_as_told(random_cvt(lattice, 40, 1, options));
    }
    options.run.max_iterations = 0;
    for (const std::uint64_t seed : {1, 2, 3})
        expect_as_told(random_cvt(lattice, 40000, seed, options));
}

TEST(Cvt, ZeroIterationsKeepTheSitesAsGiven) {
    const Lattice unit = Lattice::rectangle(1, 1);
    const Points points = uniform_points(unit, 25, 2);
    CvtOptions options;
    options.run.max_iterations = 0;
    const CvtResult result = compute_cvt(unit, points, options);
    EXPECT_EQ(result.run.stop, Stop::kIterationLimit);
    for (SiteId s = 0; s < 25; ++s) {
        EXPECT_LT((result.delaunay.sites().position(s) - points.col(s)).norm(), 0x1p-51);
    }
}

// The optimiser sorts the sites internally; the result must follow the caller's order.
TEST(Cvt, SitesStayInTheCallersOrder) {
    for (const auto& [name, lattice] : lattices()) {
        for (const int n_iterations : {0, 1}) {
            const Points points = uniform_points(lattice, 60, 6);
            CvtOptions options;
            options.run.max_iterations = n_iterations;
            const CvtResult result = compute_cvt(lattice, points, options);
            const Sites& sites = result.delaunay.sites();
            const double most = n_iterations * 0.5 * sites.spacing();
            double farthest = 0;
            for (SiteId s = 0; s < sites.n_sites(); ++s) {
                farthest = std::max(farthest, testing::squared_distance(sites, s, points.col(s)));
            }
            EXPECT_LE(std::sqrt(farthest), most * (1 + 1e-6) + 1e-12 * sites.spacing()) << name;
            EXPECT_EQ(farthest > 1e-6 * sites.spacing(), n_iterations > 0) << name;
        }
    }
}

/// The positions of the sites of a result.
Points positions(const CvtResult& result) {
    const Sites& sites = result.delaunay.sites();
    Points points(2, sites.n_sites());
    for (SiteId s = 0; s < sites.n_sites(); ++s) points.col(s) = sites.position(s);
    return points;
}

double longest_move(const CvtResult& from, const CvtResult& to) {
    const Sites& sites = to.delaunay.sites();
    double longest = 0;
    for (SiteId s = 0; s < sites.n_sites(); ++s) {
        const Vec2 p = from.delaunay.sites().position(s);
        longest = std::max(longest, testing::squared_distance(sites, s, p));
    }
    return std::sqrt(longest) / sites.spacing();
}

// A rejected trial must not change the position from which the next trial starts.
TEST(Cvt, NoSiteMovesFurtherThanHalfOfH) {
    for (const auto& lattice : {Lattice::rectangle(1, 1), Lattice({1, 0}, {0.37, 0.81})}) {
        for (std::uint64_t seed = 0; seed < 5; ++seed) {
            CvtOptions options = to_tolerance(0);
            options.run.max_iterations = 0;
            CvtResult before = random_cvt(lattice, 40, seed, options);
            while (options.run.max_iterations < 30) {
                ++options.run.max_iterations;
                CvtResult after = random_cvt(lattice, 40, seed, options);
                EXPECT_LE(longest_move(before, after), 0.5 * (1 + 1e-6));
                before = std::move(after);
            }
        }
    }
}

TEST(Cvt, ALloydStepEndsAtTheCentroids) {
    const Lattice lattice({1, 0}, {0.37, 0.81});
    const CvtResult before = random_cvt(lattice, 60, 8, to_tolerance(1e-2));
    CvtOptions one_step = to_tolerance(0);
    one_step.run.solver = Solver::kLloyd;
    one_step.run.max_iterations = 1;
    const CvtResult after = compute_cvt(lattice, positions(before), one_step);
    const testing::PlaneEnergy state = testing::energy_at(before.delaunay.sites());
    const Sites& sites = after.delaunay.sites();
    for (SiteId s = 0; s < sites.n_sites(); ++s) {
        const Vec2 centroid =
            before.delaunay.sites().position(s) - state.gradient.col(s) / (2 * state.mass[s]);
        EXPECT_LT(std::sqrt(testing::squared_distance(sites, s, centroid)), 1e-8 * sites.spacing());
    }
}

/// The number of evaluations down to an RMS residual of 1e-6 for n = 1000 in the unit square.
int evaluations_to_rms(Solver solver, std::uint64_t seed) {
    int evaluations = 0;
    CvtOptions options = to_tolerance(0);
    options.run.solver = solver;
    options.run.progress = [&](const Progress& p) {
        evaluations = p.evaluations;
        return p.rms_residual > 1e-6;
    };
    EXPECT_EQ(random_cvt(Lattice::rectangle(1, 1), 1000, seed, options).run.stop, Stop::kCancelled);
    return evaluations;
}

TEST(SlowCvt, LbfgsNeedsFewEvaluationsAndLloydMany) {
    std::vector<int> evaluations;
    for (std::uint64_t seed = 0; seed < 9; ++seed) {
        evaluations.push_back(evaluations_to_rms(Solver::kPlainLbfgs, seed));
    }
    std::sort(evaluations.begin(), evaluations.end());
    RecordProperty("lbfgs_median", evaluations[4]);
    EXPECT_LE(evaluations[4], 350);
    const int lloyd = evaluations_to_rms(Solver::kLloyd, 0);
    RecordProperty("lloyd", lloyd);
    EXPECT_GT(lloyd, 2000);
}

CvtResult to_machine_precision(Solver solver, int n, std::uint64_t seed) {
    CvtOptions options = to_tolerance(1e-10);
    options.run.solver = solver;
    CvtResult result = random_cvt(Lattice::rectangle(1, 1), n, seed, options);
    EXPECT_EQ(result.run.stop, Stop::kConverged);
    return result;
}

TEST(Cvt, NewtonFinishesInFewEvaluations) {
    std::vector<int> evaluations;
    for (std::uint64_t seed = 0; seed < 9; ++seed) {
        const CvtResult result = to_machine_precision(Solver::kLbfgs, 1000, seed);
        evaluations.push_back(result.run.evaluations);
        EXPECT_GT(result.run.cg_products, result.run.hessians);
    }
    std::sort(evaluations.begin(), evaluations.end());
    RecordProperty("median", evaluations[4]);
    EXPECT_LE(evaluations[4], 230);
    EXPECT_LE(to_machine_precision(Solver::kNewton, 1000, 0).run.evaluations, 400);
    const CvtResult plain = to_machine_precision(Solver::kPlainLbfgs, 1000, 1);
    EXPECT_EQ(plain.run.hessians, 0);
    EXPECT_GT(plain.run.evaluations, 300);
}

TEST(SlowCvt, NewtonFinishesTenThousandSites) {
    std::vector<int> evaluations;
    for (const std::uint64_t seed : {0, 1, 2}) {
        evaluations.push_back(to_machine_precision(Solver::kLbfgs, 10000, seed).run.evaluations);
    }
    std::sort(evaluations.begin(), evaluations.end());
    EXPECT_LE(evaluations[1], 500);
}

/// The best lattice of the unit square, each coordinate moved by a normal deviate times 0.1 h.
Points noisy_lattice(const testing::SublatticeBasis& basis, std::uint64_t seed) {
    Points points = testing::sublattice_points(Lattice::rectangle(1, 1), basis);
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal(0, 0.1 / std::sqrt(double(points.cols())));
    for (double& x : points.reshaped()) x += normal(random);
    return points;
}

TEST(Cvt, NewtonBeginsAtOnceNearALattice) {
    for (const std::uint64_t seed : {0, 1, 2}) {
        const CvtResult result = compute_cvt(
            Lattice::rectangle(1, 1), noisy_lattice({2000, 702, 5}, seed), to_tolerance(1e-10));
        EXPECT_EQ(result.run.stop, Stop::kConverged);
        EXPECT_LE(result.run.evaluations, 10);
        EXPECT_NEAR(result.run.energy / result.energy_bound, 1.00001712, 1e-8);
    }
}

TEST(SlowCvt, NewtonBeginsAtOnceNearALargeLattice) {
    const CvtResult result = compute_cvt(Lattice::rectangle(1, 1),
                                         noisy_lattice({4000, 1223, 25}, 0), to_tolerance(1e-10));
    EXPECT_EQ(result.run.stop, Stop::kConverged);
    EXPECT_LE(result.run.evaluations, 10);
}

TEST(Cvt, LloydNeverRaisesTheEnergy) {
    double previous = 1e300;
    CvtOptions options = to_tolerance(1e-5);
    options.run.solver = Solver::kLloyd;
    options.run.progress = [&](const Progress& p) {
        EXPECT_LE(p.value, previous * (1 + 1e-14));
        previous = p.value;
        return true;
    };
    EXPECT_EQ(random_cvt(Lattice::rectangle(20, 1), 60, 1, options).run.stop, Stop::kConverged);
}

TEST(Cvt, TheUnitOfLengthDoesNotMatter) {
    const CvtResult one = random_cvt(Lattice::rectangle(1, 1), 60, 4, to_tolerance(1e-8));
    for (const double scale : {0x1p-190, 0x1p-20, 0x1p190}) {
        const CvtResult scaled =
            random_cvt(Lattice::rectangle(scale, scale), 60, 4, to_tolerance(1e-8));
        EXPECT_EQ(scaled.run.stop, Stop::kConverged);
        EXPECT_EQ(scaled.run.evaluations, one.run.evaluations);
        EXPECT_EQ(scaled.delaunay.sites().coordinates(), one.delaunay.sites().coordinates());
        EXPECT_DOUBLE_EQ(scaled.run.energy / scaled.energy_bound,
                         one.run.energy / one.energy_bound);
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

void expect_same_bits(const CvtResult& first, const CvtResult& second) {
    EXPECT_EQ(first.delaunay.sites().coordinates(), second.delaunay.sites().coordinates());
    EXPECT_EQ(first.run.energy, second.run.energy);
    EXPECT_EQ(first.run.residual, second.run.residual);
    EXPECT_EQ(first.run.rms_residual, second.run.rms_residual);
    EXPECT_EQ(first.run.evaluations, second.run.evaluations);
    EXPECT_EQ(first.counts.n_flips, second.counts.n_flips);
}

TEST(Cvt, TheSameInputGivesTheSameBits) {
    const Lattice lattice({0.5, 0.1}, {-0.2, 2});
    expect_same_bits(random_cvt(lattice, 80, 3, to_tolerance(1e-7)),
                     random_cvt(lattice, 80, 3, to_tolerance(1e-7)));
}

void expect_same_bits_for_threads(int n, CvtOptions options) {
    const Lattice lattice({1, 0}, {0.37, 0.81});
    options.run.n_threads = 1;
    const CvtResult one = random_cvt(lattice, n, 5, options);
    for (const int n_threads : {2, 3}) {
        options.run.n_threads = n_threads;
        expect_same_bits(random_cvt(lattice, n, 5, options), one);
    }
}

TEST(Cvt, TheNumberOfThreadsDoesNotMatter) {
    expect_same_bits_for_threads(1000, to_tolerance(1e-4));
    CvtOptions few_iterations = to_tolerance(0);
    few_iterations.run.max_iterations = 5;
    expect_same_bits_for_threads(40000, few_iterations);
    few_iterations.run.solver = Solver::kLloyd;
    few_iterations.run.max_iterations = 2;
    expect_same_bits_for_threads(40000, few_iterations);
    few_iterations.run.solver = Solver::kNewton;
    few_iterations.run.max_iterations = 4;
    expect_same_bits_for_threads(40000, few_iterations);
}

// From random sites to an RMS residual of 1e-3 the triangulation is repaired and never rebuilt.
TEST(Cvt, NeedsFewFlipsPerSiteAndNoRebuild) {
    for (const Lattice& lattice :
         {Lattice::rectangle(1, 1), Lattice({1, 0}, {0.37, 0.81}), Lattice::rectangle(20, 1)}) {
        const int n = 10000;
        CvtOptions options = to_tolerance(0);
        options.run.progress = [](const Progress& p) { return p.rms_residual > 1e-3; };
        const CvtResult result = random_cvt(lattice, n, 7, options);
        EXPECT_EQ(result.run.stop, Stop::kCancelled);
        EXPECT_EQ(result.counts.n_rebuilds, 0);
        EXPECT_GT(result.counts.n_flips, 0);
        EXPECT_LE(double(result.counts.n_flips), 2.2 * n);
        EXPECT_FALSE(result.counts.n_mirrors.has_value());
    }
}

}  // namespace
}  // namespace pcvt::plane
