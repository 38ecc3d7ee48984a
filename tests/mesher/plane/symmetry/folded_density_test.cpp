#include "mesher/plane/symmetry/folded_density.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

#include "tests/support/densities.hpp"
#include "tests/support/symmetry.hpp"

namespace pcvt::plane {
namespace {

Density ramp() {
    return shared_density([](const DensityPoint& p) { return 1 + p.u + 10 * p.v; });
}

TEST(FoldedDensity, HasTheSymmetryAndIsTheDensityInOneUnit) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform;
    for (const PlaneGroupRow& row : kPlaneGroups) {
        const PlaneGroup group(row.name, testing::fitting_lattice(row.name));
        const Density folded = folded_density(ramp(), group);
        const DensityProbe probe(group.lattice(), folded.make_function());
        const DensityFunction function = folded.make_function();
        int n_in_unit = 0;
        for (int k = 0; k < 1000; ++k) {
            const Vec2 u(uniform(random), uniform(random));
            const double rho = testing::value_at(function, probe.point(u));
            if (folded_point(group, u) == u) {
                ++n_in_unit;
                EXPECT_EQ(rho, 1 + u.x() + 10 * u.y());
            }
            for (const LatticeIsometry& g : group.given_operations()) {
                const Vec2 image = g(u);
                const Vec2 wrapped = image.array() - image.array().floor();
                EXPECT_NEAR(testing::value_at(function, probe.point(wrapped)), rho, 1e-12)
                    << row.word;
            }
        }
        // The unit is 1 / order of the domain.
        EXPECT_NEAR(n_in_unit * group.order() / 1000.0, 1, 0.25) << row.word;
    }
}

TEST(FoldedDensity, GivesTheFunctionThePointItIsFoldedTo) {
    const PlaneGroup group(PlaneGroupName::kPm, Lattice::rectangle(3, 2));
    const Density folded = folded_density(
        shared_density([](const DensityPoint& p) { return 1 + p.x + 100 * p.y; }), group);
    const DensityProbe probe(group.lattice(), folded.make_function());
    EXPECT_DOUBLE_EQ(testing::value_at(folded.make_function(), probe.point(0.5, 0.75)), 52.5);
}

/// Compares the values at points by columns with those at single points.
void expect_same_bits_by_columns(const Density& density, const Lattice& lattice) {
    const DensityFunction function = density.make_function();
    ASSERT_TRUE(function.takes_columns());
    const DensityProbe probe(lattice, function);
    std::mt19937_64 random(1);
    std::uniform_int_distribution<int> uniform(0, 64);
    std::array<std::vector<double>, 4> columns;
    for (int k = 0; k < 400; ++k) {
        // Many points have several images with the same u.
        const DensityPoint p = probe.point(uniform(random) / 64.0, uniform(random) / 64.0);
        columns[0].push_back(p.x);
        columns[1].push_back(p.y);
        columns[2].push_back(p.u);
        columns[3].push_back(p.v);
    }
    std::vector<double> rho(400);
    function({{columns[0].data(), columns[1].data(), columns[2].data(), columns[3].data()}, 400},
             rho.data());
    for (std::size_t k = 0; k < rho.size(); ++k) {
        EXPECT_EQ(rho[k], testing::value_at(function, {columns[0][k], columns[1][k], columns[2][k],
                                                       columns[3][k]}));
    }
}

double wave(const DensityPoint& p) { return p.x + 10 * p.y + 100 * p.u + 1000 * p.v; }

TEST(FoldedDensity, HasTheSameBitsForPointsByColumns) {
    const Density density = testing::density_of_columns(wave, {true, true, true, true});
    for (const PlaneGroupRow& row : kPlaneGroups) {
        const PlaneGroup group(row.name, testing::fitting_lattice(row.name));
        SCOPED_TRACE(row.word);
        expect_same_bits_by_columns(folded_density(density, group), group.lattice());
    }
}

TEST(MirroredDensity, HasTheSameBitsForPointsByColumns) {
    const Density density = testing::density_of_columns(wave, {true, true, true, true});
    for (const Walls walls : {Walls::kX, Walls::kY, Walls::kXY}) {
        expect_same_bits_by_columns(mirrored_density(density, walls), Lattice::rectangle(3, 2));
    }
}

TEST(FoldedDensity, MapsBreakLines) {
    Density density = ramp();
    density.u_breaks = {0.1};
    const PlaneGroup group(PlaneGroupName::kP4m, Lattice::rectangle(1, 1));
    const Density folded = folded_density(density, group);
    const std::vector<double> expected{0.1, 0.25, 0.5, 0.75, 0.9};
    ASSERT_EQ(folded.u_breaks.size(), expected.size());
    ASSERT_EQ(folded.v_breaks.size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
        EXPECT_DOUBLE_EQ(folded.u_breaks[k], expected[k]);
        EXPECT_DOUBLE_EQ(folded.v_breaks[k], expected[k]);
    }
}

}  // namespace
}  // namespace pcvt::plane
