#include <gmock/gmock.h>

#include <random>

#include "mesher/plane/cvt/cvt.hpp"
#include "tests/support/densities.hpp"
#include "tests/support/energy_at.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

struct Problem {
    Lattice lattice;
    Points points;
    CvtOptions options;
};

/// Each site is fixed with the given probability, in any order and some twice.
Problem random_problem(const Lattice& lattice, int n, double probability, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    Problem problem{lattice, uniform_points(lattice, n, seed), {}};
    for (SiteId s = n - 1; s >= 0; --s) {
        if (unit(random) < probability) problem.options.fixed.push_back(s);
        if (unit(random) < probability / 4) problem.options.fixed.push_back(s);
    }
    return problem;
}

CvtResult solve(const Problem& problem) {
    return compute_cvt(problem.lattice, problem.points, problem.options);
}

std::vector<bool> mask(const Problem& problem) {
    std::vector<bool> is_fixed(static_cast<std::size_t>(problem.points.cols()), false);
    for (const SiteId s : problem.options.fixed) is_fixed[s] = true;
    return is_fixed;
}

/// Fixed sites have not moved by a bit.
void expect_fixed(const Problem& problem, const CvtResult& result) {
    const Sites before(problem.lattice, problem.points);
    for (const SiteId s : problem.options.fixed) {
        EXPECT_EQ(result.delaunay.sites().coordinates().col(s), before.coordinates().col(s));
    }
}

/// Every free site lies at the centroid of its cell.
void expect_free_at_centroids(const Problem& problem, const CvtResult& result) {
    const Sites& sites = result.delaunay.sites();
    const testing::PlaneEnergy energy = testing::energy_at(sites);
    const std::vector<bool> is_fixed = mask(problem);
    double largest = 0;
    double sum = 0;
    int n_free = 0;
    for (SiteId s = 0; s < sites.n_sites(); ++s) {
        if (is_fixed[s]) continue;
        const double move = energy.gradient.col(s).norm() / (2 * energy.mass[s]);
        largest = std::max(largest, move / sites.spacing());
        sum += std::pow(move / sites.spacing(), 2);
        ++n_free;
    }
    EXPECT_LE(largest, problem.options.run.tolerance * (1 + 1e-6));
    EXPECT_NEAR(result.run.residual, largest, 1e-3 * largest + 1e-13);
    EXPECT_NEAR(result.run.rms_residual, std::sqrt(sum / std::max(1, n_free)),
                1e-3 * largest + 1e-13);
}

TEST(FixedSites, StayAndTheOthersReachTheirCentroids) {
    for (const auto& [name, lattice] : testing::lattices()) {
        for (const int n : {1, 2, 3, 4, 5, 6, 7, 8, 60, 300}) {
            for (const double probability : {0.1, 0.7}) {
                const Problem problem = random_problem(lattice, n, probability, std::uint64_t(n));
                const CvtResult result = solve(problem);
                SCOPED_TRACE(name + " n = " + std::to_string(n));
                EXPECT_EQ(result.run.stop, Stop::kConverged);
                expect_fixed(problem, result);
                expect_free_at_centroids(problem, result);
            }
        }
    }
}

TEST(FixedSites, StayWithEverySolver) {
    const Lattice lattice({1, 0}, {0.37, 0.81});
    for (const SolverRow& row : kSolvers) {
        // With 700 sites long waves are preconditioned.
        for (const int n : {40, 700}) {
            Problem problem = random_problem(lattice, n, 0.2, 3);
            problem.options.run.solver = row.solver;
            problem.options.run.tolerance = row.solver == Solver::kLloyd ? 1e-3 : 1e-8;
            problem.options.precondition_below = 1e-2;
            const CvtResult result = solve(problem);
            SCOPED_TRACE(row.word);
            EXPECT_EQ(result.run.stop, Stop::kConverged);
            expect_fixed(problem, result);
            expect_free_at_centroids(problem, result);
        }
    }
}

TEST(FixedSites, SlowStayWithADensity) {
    const Lattice lattice({1, 0}, {0.37, 0.81});
    for (const SolverRow& row : kSolvers) {
        for (const int n : {5, row.solver == Solver::kLbfgs ? 600 : 60}) {
            Problem problem = random_problem(lattice, n, 0.2, 4);
            problem.options.run.solver = row.solver;
            problem.options.density = testing::smooth_density();
            problem.options.run.tolerance = row.solver == Solver::kLloyd ? 1e-2 : 1e-5;
            const CvtResult result = solve(problem);
            EXPECT_EQ(result.run.stop, Stop::kConverged) << row.word << " n = " << n;
            EXPECT_LE(result.run.residual, problem.options.run.tolerance);
            expect_fixed(problem, result);
            // A second run from there has nothing to do.
            const CvtResult again = compute_cvt(result.delaunay.sites(), problem.options);
            EXPECT_LE(again.run.iterations, 2);
        }
    }
}

TEST(FixedSites, NewtonUsesTheirHessian) {
    Problem problem = random_problem(Lattice::rectangle(1, 1), 300, 0.3, 5);
    problem.options.run.tolerance = 1e-10;
    const int with_newton = solve(problem).run.evaluations;
    problem.options.run.solver = Solver::kPlainLbfgs;
    EXPECT_LT(with_newton, 0.7 * solve(problem).run.evaluations);
}

TEST(FixedSites, MayBeAll) {
    Problem problem = random_problem(Lattice::rectangle(2, 1), 30, 1, 6);
    const CvtResult result = solve(problem);
    EXPECT_EQ(result.run.stop, Stop::kConverged);
    EXPECT_EQ(result.run.iterations, 0);
    const Sites sites(problem.lattice, problem.points);
    EXPECT_EQ(result.delaunay.sites().coordinates(), sites.coordinates());
    EXPECT_NEAR(result.run.energy / testing::energy_at(sites).value, 1, 1e-14);
}

TEST(FixedSites, AreRefusedIfTheyAreNoSites) {
    for (const SiteId bad : {-1, 20}) {
        Problem problem = random_problem(Lattice::rectangle(1, 1), 20, 0, 7);
        problem.options.fixed = {3, bad};
        EXPECT_THROW(solve(problem), InvalidInput);
    }
    Problem problem = random_problem(Lattice::rectangle(1, 1), 20, 0.5, 7);
    problem.options.numbering = Numbering::kByColumns;
    EXPECT_THROW(solve(problem), InvalidInput);
}

/// Admits sites 0 and 1 only on their own sides of v = 1/2.
class HalfPlanes final : public SiteGuard<MovingDelaunay> {
   public:
    bool admits(const MovingDelaunay& delaunay) override {
        for (SiteId s = 0; s < delaunay.n_sites(); ++s) {
            const SiteId id = delaunay.original_id(s);
            double v = delaunay.coordinates()(1, s);
            v -= std::floor(v);
            if (id < 2 && (v < 0.5) != (id == 0)) return false;
        }
        return true;
    }
};

TEST(SiteGuard, KeepsSitesWhereTheyAreAdmitted) {
    const Lattice unit = Lattice::rectangle(1, 1);
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        Points points = uniform_points(unit, 40, seed);
        points.col(0) << 0.3, 0.49;
        points.col(1) << 0.7, 0.51;
        for (const bool with_density : {false, true}) {
            HalfPlanes guard;
            CvtOptions options;
            options.guard = &guard;
            options.run.max_iterations = 40;
            if (with_density) options.density = testing::smooth_density();
            const CvtResult result = compute_cvt(unit, points, options);
            EXPECT_LT(result.delaunay.sites().coordinates()(1, 0), 0.5);
            EXPECT_GE(result.delaunay.sites().coordinates()(1, 1), 0.5);
        }
    }
}

}  // namespace
}  // namespace pcvt::plane
