#include <gtest/gtest.h>

#include <cmath>

#include "mesher/plane/cvt/clipped_cvt.hpp"
#include "mesher/plane/cvt/cvt.hpp"
#include "tests/support/densities.hpp"
#include "tests/support/energy_at.hpp"
#include "tests/support/symmetry.hpp"

namespace pcvt::plane {
namespace {

using testing::expect_symmetric;
using testing::fitting_lattice;

CvtOptions to_tolerance(double tolerance) {
    CvtOptions options;
    options.run.tolerance = tolerance;
    return options;
}

SymmetricSites start_of(const PlaneGroup& group, int n, std::uint64_t seed) {
    return random_sites(group, distribute(group, special_positions(group), n), seed);
}

void expect_sound(const SymmetricSites& start, const CvtResult& result) {
    const Sites& sites = result.delaunay.sites();
    expect_symmetric(start, sites);
    const char* word = start.group.row().word;
    EXPECT_GE(result.run.energy, result.energy_bound * (1 - 1e-12)) << word;
    // The sums of many sites have other roundings in another order.
    const double rounding = sites.n_sites() < 10'000 ? 1e-14 : 1e-13;
    EXPECT_NEAR(result.run.energy / testing::energy_at(sites).value, 1, rounding) << word;
}

TEST(SymmetricCvt, KeepsOneToTwelveOrbitsOfEveryGroup) {
    for (const PlaneGroupRow& row : kPlaneGroups) {
        const PlaneGroup group(row.name, fitting_lattice(row.name));
        for (int n = 1; n <= 12; ++n) {
            const SymmetricSites start = start_of(group, n * group.order(), 1);
            const CvtResult result = compute_cvt(start, to_tolerance(1e-7));
            EXPECT_EQ(result.run.stop, Stop::kConverged) << row.word << ", " << n << " orbits";
            EXPECT_LE(result.run.residual, 1e-7);
            expect_sound(start, result);
        }
    }
}

TEST(SymmetricCvt, KeepsSitesAtCentresAndOnMirrors) {
    for (const PlaneGroupRow& row : kPlaneGroups) {
        const PlaneGroup group(row.name, fitting_lattice(row.name));
        const SpecialPositions special = special_positions(group);
        for (const int n : {0, 1, 4}) {
            const OrbitPlan plan{n, std::vector<int>(special.mirrors.size(), n + 1),
                                 std::vector<bool>(special.centres.size(), true)};
            if (n_sites(group, special, plan) == 0) continue;
            const SymmetricSites start = random_sites(group, plan, 2);
            const CvtResult result = compute_cvt(start, to_tolerance(1e-7));
            EXPECT_EQ(result.run.stop, Stop::kConverged) << row.word << ", " << n << " orbits";
            expect_sound(start, result);
        }
    }
}

TEST(SymmetricCvt, KeepsTwoHundredAndFortySitesOfEveryGroup) {
    for (const PlaneGroupRow& row : kPlaneGroups) {
        const PlaneGroup group(row.name, fitting_lattice(row.name));
        const SymmetricSites start = start_of(group, 240, 1);
        const CvtResult result = compute_cvt(start, to_tolerance(1e-10));
        EXPECT_EQ(result.run.stop, Stop::kConverged) << row.word;
        expect_sound(start, result);
    }
}

TEST(SymmetricCvt, EverySolverConverges) {
    for (const Solver solver : {Solver::kLloyd, Solver::kNewton, Solver::kPlainLbfgs}) {
        for (const PlaneGroupName name : {PlaneGroupName::kPmm, PlaneGroupName::kP6m}) {
            const PlaneGroup group(name, fitting_lattice(name));
            const SymmetricSites start = start_of(group, 61, 4);
            CvtOptions options = to_tolerance(1e-5);
            options.run.solver = solver;
            const CvtResult result = compute_cvt(start, options);
            EXPECT_EQ(result.run.stop, Stop::kConverged) << group.row().word;
            expect_sound(start, result);
        }
    }
}

TEST(SymmetricCvt, PreconditionsLongWaves) {
    const PlaneGroup group(PlaneGroupName::kP4m, fitting_lattice(PlaneGroupName::kP4m));
    const SymmetricSites start = start_of(group, 4001, 4);
    CvtOptions options = to_tolerance(1e-5);
    options.run.solver = Solver::kPlainLbfgs;
    options.precondition_below = 0;
    const CvtResult without = compute_cvt(start, options);
    options.run.solver = Solver::kLbfgs;
    options.precondition_below = 3e-4;
    const CvtResult with = compute_cvt(start, options);
    EXPECT_EQ(with.run.stop, Stop::kConverged);
    expect_sound(start, with);
    EXPECT_LT(with.run.evaluations, without.run.evaluations);
}

TEST(SymmetricCvt, IsTheSameForAnyNumberOfThreads) {
    const PlaneGroup group(PlaneGroupName::kP6m, fitting_lattice(PlaneGroupName::kP6m));
    const SymmetricSites start = start_of(group, 40'003, 4);
    CvtOptions options;
    options.run.max_iterations = 8;
    options.precondition_below = 1;
    const CvtResult one = compute_cvt(start, options);
    for (const int n_threads : {2, 3}) {
        options.run.n_threads = n_threads;
        const CvtResult more = compute_cvt(start, options);
        EXPECT_EQ(more.delaunay.sites().coordinates(), one.delaunay.sites().coordinates());
        EXPECT_EQ(more.run.energy, one.run.energy);
    }
    expect_sound(start, one);
}

TEST(SymmetricCvt, SlowFollowsAFoldedDensity) {
    for (const PlaneGroupRow& row : kPlaneGroups) {
        if (row.system == LatticeSystem::kHexagonal) continue;
        const PlaneGroup group(row.name, fitting_lattice(row.name));
        const SymmetricSites start = start_of(group, 80, 4);
        CvtOptions options = to_tolerance(1e-5);
        options.density = shared_density([](const DensityPoint& p) {
            return 2 + std::sin(2 * std::numbers::pi * (p.u + 0.1)) *
                           std::cos(2 * std::numbers::pi * p.v);
        });
        const CvtResult result = compute_cvt(start, options);
        expect_symmetric(start, result.delaunay.sites());
        EXPECT_LT(result.run.residual, 1e-3) << row.word;
    }
    // With the symmetry the density is smooth, and the run converges.
    const PlaneGroup group(PlaneGroupName::kP4m, Lattice::rectangle(1, 1));
    const SymmetricSites start = start_of(group, 121, 4);
    CvtOptions options = to_tolerance(1e-8);
    options.density = shared_density([](const DensityPoint& p) {
        return std::exp(std::cos(2 * std::numbers::pi * p.u) +
                        std::cos(2 * std::numbers::pi * p.v));
    });
    const CvtResult result = compute_cvt(start, options);
    EXPECT_EQ(result.run.stop, Stop::kConverged);
    EXPECT_EQ(result.density->n_rough_cells, 0);
    expect_symmetric(start, result.delaunay.sites());
}

// A box with walls is a quarter of the torus with the symmetry pmm.
TEST(SymmetricCvt, OfABoxIsTheClippedOne) {
    const double width = 1.3;
    const double height = 0.9;
    const Lattice box = Lattice::rectangle(width, height);
    const PlaneGroup group(PlaneGroupName::kPmm, Lattice::rectangle(2 * width, 2 * height));
    for (const int n : {10, 40, 150}) {
        const SymmetricSites start = orbits_of(group, uniform_points(box, n, 3));
        ASSERT_EQ(start.sites.n_sites(), 4 * n);
        const CvtResult result = compute_cvt(start, to_tolerance(1e-12));
        EXPECT_EQ(result.run.stop, Stop::kConverged);
        expect_sound(start, result);
        Points quarter(2, n);
        int count = 0;
        for (SiteId s = 0; s < 4 * n; ++s) {
            const Vec2 u = group.lattice().to_lattice(result.delaunay.sites().position(s));
            const Vec2 p = group.lattice().to_position(u.array() - u.array().floor());
            if (p.x() >= width || p.y() >= height) continue;
            ASSERT_LT(count, n);
            quarter.col(count++) = p;
        }
        ASSERT_EQ(count, n);
        const ClippedEnergy clipped = clipped_energy(box, quarter);
        EXPECT_NEAR(result.run.energy / (4 * clipped.value), 1, 1e-14);
        const auto moves =
            clipped.gradient.array().rowwise() / (2 * clipped.mass.transpose().array());
        EXPECT_LT(moves.abs().maxCoeff() / std::sqrt(box.area() / n), 2e-12);
    }
}

/// A channel is half of the torus with the symmetry pm: integrals over a strip by brute force.
TEST(SymmetricCvt, OfAChannelIsAPeriodicStrip) {
    const PlaneGroup group(PlaneGroupName::kPm, Lattice::rectangle(1, 2));
    const SymmetricSites start = start_of(group, 24, 5);
    const CvtResult result = compute_cvt(start, to_tolerance(1e-10));
    const Sites& sites = result.delaunay.sites();
    constexpr int kSteps = 600;
    double sum = 0;
    for (int i = 0; i < kSteps * kSteps; ++i) {
        const Vec2 p = Vec2(i % kSteps + 0.5, i / kSteps + 0.5) / kSteps;
        double nearest = 10;
        for (SiteId s = 0; s < sites.n_sites(); ++s) {
            const Vec2 q = sites.position(s);
            if (q.y() > 1) continue;
            Vec2 d = p - q;
            d.x() -= std::round(d.x());
            nearest = std::min(nearest, d.squaredNorm());
        }
        sum += nearest;
    }
    EXPECT_NEAR(2 * sum / (kSteps * kSteps) / result.run.energy, 1, 1e-5);
}

}  // namespace
}  // namespace pcvt::plane
