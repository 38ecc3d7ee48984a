#include "mesher/plane/energy/patch_energy.hpp"

#include <gtest/gtest.h>

#include <random>

#include "mesher/plane/cvt/cvt.hpp"
#include "mesher/plane/energy/energy.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

/// Sites near a minimum: triangles of random sites are too thin for a pass over a patch.
MovingDelaunay relaxed(const Lattice& lattice, int n, std::uint64_t seed) {
    CvtOptions options;
    options.run.max_iterations = 15;
    return MovingDelaunay(
        compute_cvt(lattice, uniform_points(lattice, n, seed), options).delaunay.sites());
}

Energy energy_of(MovingDelaunay& whole) {
    Workers workers(1);
    Energy energy;
    EXPECT_TRUE(EnergyPass(whole, workers).evaluate(energy));
    return energy;
}

/// The derivatives at the sites of a patch equal those of the whole triangulation.
void expect_equal(const DelaunayPatch& patch, const Energy& of_patch, const Energy& of_whole,
                  double spacing) {
    const double unit = std::pow(spacing, 3);
    for (int k = 0; k < patch.n_sites(); ++k) {
        const SiteId s = patch.moving()[k];
        EXPECT_NEAR(of_patch.gradient[2 * k], of_whole.gradient[2 * s], 1e-12 * unit);
        EXPECT_NEAR(of_patch.gradient[2 * k + 1], of_whole.gradient[2 * s + 1], 1e-12 * unit);
        EXPECT_NEAR(of_patch.mass[k], of_whole.mass[s], 1e-12 * spacing * spacing);
    }
}

TEST(PatchPass, EqualsThePassOverAllTriangles) {
    std::mt19937_64 random(1);
    std::int64_t n_flips = 0;
    for (const auto& [name, lattice] : testing::lattices()) {
        for (const int n : {300, 900}) {
            SCOPED_TRACE(name + " n = " + std::to_string(n));
            MovingDelaunay whole = relaxed(lattice, n, random());
            const double spacing = whole.spacing();
            Workers workers(1);
            const Energy before = energy_of(whole);
            const PatchPlans plans(whole.triangulation(), {n / 3}, {}, 4);
            DelaunayPatch patch(whole, plans, 0);
            PatchPass pass(patch, workers);
            Energy at_start;
            ASSERT_TRUE(pass.evaluate(at_start));
            expect_equal(patch, at_start, before, spacing);
            // Move the sites so far that edges flip.
            std::normal_distribution<float> normal(0, 0.12F * float(spacing));
            Eigen::VectorXf direction(2 * patch.n_sites());
            for (float& x : direction) x = normal(random);
            Energy at_end;
            if (!patch.step(direction, 1, workers) || !pass.evaluate(at_end)) continue;
            patch.settle();
            n_flips += std::ssize(patch.flips());
            whole.adopt(patch.moving(), patch.coordinates(), patch.flips());
            const Energy after = energy_of(whole);
            expect_equal(patch, at_end, after, spacing);
            EXPECT_NEAR(at_end.value - at_start.value, after.value - before.value,
                        1e-11 * before.value);
        }
    }
    EXPECT_GT(n_flips, 20);
}

TEST(PatchPass, IsUndefinedWhereATriangleIsInverted) {
    const Lattice unit = Lattice::rectangle(1, 1);
    MovingDelaunay whole = relaxed(unit, 300, 1);
    const PatchPlans plans(whole.triangulation(), {100}, {}, 2);
    DelaunayPatch patch(whole, plans, 0);
    Workers workers(1);
    PatchPass pass(patch, workers);
    Eigen::VectorXf direction = Eigen::VectorXf::Zero(2 * patch.n_sites());
    direction[0] = 3 * float(whole.spacing());
    Energy energy;
    ASSERT_TRUE(patch.step(direction, 1, workers));
    EXPECT_FALSE(pass.evaluate(energy));
    patch.step_back();
    EXPECT_TRUE(pass.evaluate(energy));
}

}  // namespace
}  // namespace pcvt::plane
