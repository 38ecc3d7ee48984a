#include "mesher/space/power/power_cells.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>
#include <set>

#include "mesher/space/energy/energy_pass.hpp"
#include "mesher/space/power/power_diagram.hpp"
#include "mesher/space/power/power_flips.hpp"
#include "tests/support/random_space_sites.hpp"
#include "tests/support/space_cells.hpp"
#include "tests/support/space_lattices.hpp"
#include "tests/support/space_weights.hpp"

namespace pcvt::space {
namespace {

/// A diagram of moving tetrahedra, with the way back to the order and the axes of the sites.
struct Diagram {
    Sites sites;
    MovingTetrahedra moving;
    Workers workers{1};
    PowerDiagram diagram;
    bool visible = false;

    /// @param weights  by site, length^2.
    Diagram(const Sites& given, const Eigen::VectorXd& weights)
        : sites(given), moving(given), diagram(moving, workers) {
        diagram.start();
        visible = diagram.set_weights(ordered(weights));
    }
    Eigen::VectorXd ordered(const Eigen::VectorXd& weights) const {
        Eigen::VectorXd result(weights.size());
        const double unit = moving.unit();
        for (SiteId s = 0; s < sites.n_sites(); ++s) {
            result[s] = weights[moving.original_id(s)] / (unit * unit);
        }
        return result;
    }
    /// From the frame to the axes of the sites, with the unit.
    Eigen::Matrix3d rotation() const {
        const Frame& f = moving.frame();
        Eigen::Matrix3d frame;
        frame << f.ax, f.bx, f.cx, 0, f.by, f.cy, 0, 0, f.cz;
        Eigen::Matrix3d periods;
        for (int k = 0; k < 3; ++k) periods.col(k) = sites.reduction().reduced.periods()[k];
        return periods * frame.inverse();
    }
};

/// Law 1, relative to a period and to the domain.
void expect_polyhedra(const Diagram& d, const Eigen::VectorXd& weights, double tolerance) {
    Workers workers(1);
    Energy cells;
    measure_cells(d.diagram.regular(), workers, cells);
    const testing::BruteForceEnergy expected = testing::brute_force_energy(d.sites, weights);
    const double unit = d.moving.unit();
    const double volume = d.sites.lattice().volume();
    const double length = d.sites.reduction().reduced.c().norm();
    for (SiteId s = 0; s < d.sites.n_sites(); ++s) {
        const SiteId id = d.moving.original_id(s);
        ASSERT_NEAR(cells.mass[s] * std::pow(unit, 3), expected.volumes[id], tolerance * volume);
        ASSERT_NEAR(d.diagram.sizes()[s], cells.mass[s], tolerance * volume / std::pow(unit, 3));
        const Vec3 gradient = std::pow(unit, 3) * (d.rotation() * cells.gradient.segment<3>(4 * s));
        ASSERT_LT((gradient - expected.gradient[id]).norm(), tolerance * volume * length);
    }
    ASSERT_NEAR(cells.value * std::pow(unit, 5), expected.value,
                tolerance * volume * length * length);
    // Law 2.
    ASSERT_NEAR(cells.mass.sum(), d.moving.frame().volume(), 1e-12 * d.moving.frame().volume());
}

TEST(SpacePowerCells, SlowEqualClippedPolyhedra) {
    std::mt19937_64 random(1);
    int n_visible = 0;
    for (int k = 0; k < 300; ++k) {
        const auto [name, sites] = testing::random_space_sites(random);
        if (sites.n_sites() > 30) continue;
        SCOPED_TRACE("input " + std::to_string(k) + ": " + name);
        const Eigen::VectorXd weights = testing::random_space_weights(sites, 0.1 * (k % 4), random);
        const Diagram diagram(sites, weights);
        if (!diagram.visible) continue;
        ++n_visible;
        expect_polyhedra(diagram, weights, 1e-11);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(n_visible, 80);
}

TEST(SpacePowerCells, WithoutWeightsAreThoseOfTheEnergy) {
    std::mt19937_64 random(2);
    for (int k = 0; k < 30; ++k) {
        const auto [name, sites] = testing::random_space_sites(random);
        SCOPED_TRACE(name);
        Diagram d(sites, Eigen::VectorXd::Zero(sites.n_sites()));
        ASSERT_TRUE(d.visible);
        Energy cells;
        measure_cells(d.diagram.regular(), d.workers, cells);
        MovingTetrahedra moving(sites);
        Energy energy;
        ASSERT_TRUE(EnergyPass(moving, d.workers).evaluate(energy));
        EXPECT_NEAR(cells.value, energy.value, 1e-11 * energy.value);
        EXPECT_LT((cells.mass - energy.mass).norm(), 1e-10 * energy.mass.norm());
        EXPECT_LT((cells.gradient - energy.gradient).norm(),
                  1e-10 * energy.mass.norm() * moving.frame().cz * sites.n_sites());
    }
}

// Law 3.
TEST(SpacePowerCells, GraphIsTheDerivativeOfTheVolumes) {
    std::mt19937_64 random(3);
    int n_visible = 0;
    for (const auto& [name, lattice] : testing::space_lattices()) {
        SCOPED_TRACE(name);
        const int n = 25;
        const Sites sites(lattice, uniform_points(lattice, n, random()));
        const Eigen::VectorXd weights = testing::random_space_weights(sites, 0.05, random);
        Diagram d(sites, weights);
        if (!d.visible) continue;
        ++n_visible;
        const CellGraph graph = d.diagram.graph();
        const double h2 = std::pow(d.moving.spacing(), 2);
        Eigen::VectorXd change(n);
        for (double& c : change) c = testing::random_number(random);
        Eigen::VectorXd expected = Eigen::VectorXd::Zero(n);
        for (SiteId s = 0; s < n; ++s) {
            for (int k = graph.row_begin[s]; k < graph.row_begin[s + 1]; ++k) {
                ASSERT_GE(graph.conductance[k], 0);
                ASSERT_NE(graph.neighbour[k], s);
                expected[s] += graph.conductance[k] * (change[s] - change[graph.neighbour[k]]);
            }
        }
        const double step = 1e-6 * h2;
        const Eigen::VectorXd here = d.diagram.weights();
        const auto volumes = [&](double t) {
            PowerDiagram other(d.moving, d.workers);
            other.start();
            EXPECT_TRUE(other.set_weights(here + t * change));
            return Eigen::VectorXd(other.sizes());
        };
        const Eigen::VectorXd difference = (volumes(step) - volumes(-step)) / (2 * step);
        EXPECT_LT((difference - expected).norm(), 1e-5 * expected.norm());
    }
    EXPECT_GT(n_visible, 8);
}

// Law 4, with several slabs.
TEST(SpacePowerCells, SlowEveryBitIsTheSameForAnyNumberOfWorkers) {
    const int n = 20'000;
    const Sites sites(testing::kCube, uniform_points(testing::kCube, n, 1));
    std::mt19937_64 random(4);
    const Diagram d(sites, testing::random_space_weights(sites, 0.02, random));
    ASSERT_TRUE(d.visible);
    Workers one(1);
    Workers three(3);
    Energy first;
    Energy second;
    measure_cells(d.diagram.regular(), one, first);
    measure_cells(d.diagram.regular(), three, second);
    EXPECT_EQ(first.value, second.value);
    EXPECT_EQ(first.gradient, second.gradient);
    EXPECT_EQ(first.mass, second.mass);
}

// Law 5, and the volumes after a correction.
TEST(SpacePowerCells, FindAllFacetsThatAreNotLocallyRegular) {
    std::mt19937_64 random(5);
    int n_irregular = 0;
    for (int k = 0; k < 60; ++k) {
        const auto [name, sites] = testing::random_space_sites(random);
        SCOPED_TRACE(name);
        const MovingTetrahedra moving(sites);
        Workers workers(1);
        const double h = moving.spacing();
        Eigen::VectorXd weights(sites.n_sites());
        for (double& w : weights) w = 0.05 * h * h * testing::random_number(random);
        TorusTetrahedra t = moving.tetrahedra();
        const WeightedTetrahedra weighted{t, moving.coordinates(), moving.frame(), weights};
        Eigen::VectorXd volumes;
        std::vector<int> suspects = VolumeSums().run(weighted, workers, volumes);
        Eigen::VectorXd of_gram = weights * moving.frame().gram_per_square;
        for (double& w : of_gram) w = rounded_weight(w);
        PowerFlips flips(t, moving.coordinates(), moving.frame().gram, of_gram);
        const std::set<int> found(suspects.begin(), suspects.end());
        for (const int f : flips.irregular_facets()) {
            ++n_irregular;
            ASSERT_TRUE(found.contains(f) || found.contains(t.opposite(f)));
        }
        if (!flips.flip(suspects)) continue;
        Eigen::VectorXd corrected = volumes;
        if (!correct_volumes(flips.take_exchanged(), weighted, corrected)) continue;
        VolumeSums().run(weighted, workers, volumes);
        EXPECT_LT((corrected - volumes).cwiseAbs().maxCoeff(), 1e-12 * moving.frame().volume());
    }
    EXPECT_GT(n_irregular, 500);
}

}  // namespace
}  // namespace pcvt::space
