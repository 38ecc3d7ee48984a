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

TEST(MirroredDensity, HasTheSameBitsForPointsByColumns) {
    const auto waves = [](const DensityPoint& p) {
        return p.x + 10 * p.y + 100 * p.u + 1000 * p.v;
    };
    const Density mirrored =
        mirrored_density(testing::density_of_columns(waves, {true, true, true, true}), Walls::kY);
    const DensityFunction function = mirrored.make_function();
    ASSERT_TRUE(function.takes_columns());
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform;
    std::array<std::vector<double>, 4> columns;
    for (std::vector<double>& column : columns) {
        for (int k = 0; k < 40; ++k) column.push_back(uniform(random));
    }
    columns[3][7] = kBelowOne;
    std::vector<double> rho(40);
    function({{columns[0].data(), columns[1].data(), columns[2].data(), columns[3].data()}, 40},
             rho.data());
    for (std::size_t k = 0; k < rho.size(); ++k) {
        EXPECT_EQ(rho[k], testing::value_at(function, {columns[0][k], columns[1][k], columns[2][k],
                                                       columns[3][k]}));
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
