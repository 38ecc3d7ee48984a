#include "mesher/plane/power/power_cells.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "mesher/plane/delaunay/moving_delaunay.hpp"
#include "mesher/plane/energy/energy.hpp"
#include "mesher/plane/power/power_flips.hpp"
#include "tests/support/clipped_power_cells.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/special_sites.hpp"

namespace pcvt::plane {
namespace {

using testing::lattices;
using testing::random_lattice;

/// A diagram in the frame and unit of a MovingDelaunay whose sites keep their order.
struct Diagram {
    Sites sites;
    MovingDelaunay delaunay;
    TorusTriangulation regular;
    Eigen::VectorXd weights;
    bool visible = false;

    Diagram(const Sites& given, const Eigen::VectorXd& cell_weights)
        : sites(given), delaunay(given), regular(delaunay.triangulation()), weights(cell_weights) {
        weights *= delaunay.spacing() * delaunay.spacing();
        const Lattice& reduced = sites.reduction().reduced;
        const Eigen::VectorXd gram_weights =
            weights * std::pow(delaunay.unit() / gram_unit(reduced), 2);
        visible =
            !PowerFlips(regular, delaunay.coordinates(), gram_of(reduced), gram_weights).run();
    }
    WeightedTriangulation weighted() const {
        return {regular, delaunay.coordinates(), delaunay.frame(), weights};
    }
    /// By the half-planes of images; site k of the diagram is site original_id(k) of `sites`.
    std::vector<Polygon> polygons() const {
        Eigen::VectorXd given(weights.size());
        for (int s = 0; s < sites.n_sites(); ++s) given[delaunay.original_id(s)] = weights[s];
        return testing::clipped_power_cells(sites, given * std::pow(delaunay.unit(), 2));
    }
};

Eigen::VectorXd weights_of_size(int n, double size, std::mt19937_64& random) {
    std::uniform_real_distribution<double> uniform(0, size);
    Eigen::VectorXd weights(n);
    for (double& w : weights) w = uniform(random);
    return weights;
}

std::vector<double> orthocentre_heights(const WeightedTriangulation& regular, Workers& workers) {
    std::vector<double> heights;
    Eigen::VectorXd mass;
    measure_masses(regular, workers, heights, mass);
    return heights;
}

Energy measured(const Diagram& diagram, Workers& workers) {
    Energy cells;
    measure_cells(diagram.weighted(), orthocentre_heights(diagram.weighted(), workers), workers,
                  cells);
    return cells;
}

/// Law 1, to within `tolerance` times the moment of a disc of the radius of the longest period.
void expect_polygons(const Diagram& diagram, double tolerance) {
    Workers workers(1);
    const Energy cells = measured(diagram, workers);
    const std::vector<Polygon> polygons = diagram.polygons();
    const double unit = diagram.delaunay.unit();
    const double rotation = std::atan2(diagram.sites.reduction().reduced.a().y(),
                                       diagram.sites.reduction().reduced.a().x());
    const Eigen::Rotation2D<double> turn(-rotation);
    double energy = 0;
    const double size = diagram.delaunay.spacing() * std::sqrt(diagram.sites.n_sites());
    for (int s = 0; s < diagram.sites.n_sites(); ++s) {
        const auto moments = testing::polygon_moments(polygons[diagram.delaunay.original_id(s)]);
        energy += moments.second / std::pow(unit, 4);
        ASSERT_NEAR(cells.mass[s], moments.area / (unit * unit), tolerance * size * size);
        const Vec2 gradient = -2 / std::pow(unit, 3) * (turn * moments.first);
        ASSERT_LT((cells.gradient.segment<2>(2 * s) - gradient).norm(),
                  tolerance * std::pow(size, 3));
    }
    ASSERT_NEAR(cells.value, energy, tolerance * std::pow(size, 4));
    // Law 2.
    ASSERT_NEAR(cells.mass.sum(), diagram.delaunay.frame().ax * diagram.delaunay.frame().by,
                tolerance * size * size);
}

TEST(PowerCells, EqualClippedPolygonsOnRandomInputs) {
    std::mt19937_64 random(1);
    const auto named = lattices();
    int n_visible = 0;
    for (int k = 0; k < 1500; ++k) {
        const int n = 1 + k % 12;
        const Lattice lattice =
            k % 2 == 0 ? random_lattice(random) : named[(k / 2) % named.size()].lattice;
        SCOPED_TRACE("input " + std::to_string(k) + " n = " + std::to_string(n));
        const Sites sites(lattice, uniform_points(lattice, n, random()));
        const Diagram diagram(sites, weights_of_size(n, 0.1 * (k % 5), random));
        if (!diagram.visible) continue;
        ++n_visible;
        expect_polygons(diagram, 3e-12);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(n_visible, 800);
}

TEST(PowerCells, EqualClippedPolygonsOnGridsAndRowsAndTheSeam) {
    std::mt19937_64 random(2);
    for (const auto& [name, sites] : testing::special_sites()) {
        if (sites.n_sites() > 40) continue;
        SCOPED_TRACE(name);
        for (const double size : {0.0, 0.01, 0.3}) {
            const Diagram diagram(sites, weights_of_size(sites.n_sites(), size, random));
            if (diagram.visible) expect_polygons(diagram, 3e-12);
            if (HasFatalFailure()) return;
        }
    }
}

TEST(PowerCells, WithoutWeightsTheyAreThoseOfTheEnergy) {
    Workers workers(1);
    for (const auto& [name, lattice] : lattices()) {
        const Diagram diagram(Sites(lattice, uniform_points(lattice, 300, 5)),
                              Eigen::VectorXd::Zero(300));
        const Energy cells = measured(diagram, workers);
        MovingDelaunay delaunay(diagram.sites);
        Energy energy;
        ASSERT_TRUE(EnergyPass(delaunay, workers).evaluate(energy));
        EXPECT_NEAR(cells.value, energy.value, 1e-12 * energy.value) << name;
        EXPECT_LT((cells.mass - energy.mass).norm(), 1e-11 * energy.mass.norm()) << name;
        EXPECT_LT((cells.gradient - energy.gradient).norm(), 1e-11 * energy.gradient.norm());
    }
}

// Law 3.
TEST(PowerCells, TheGraphIsTheDerivativeOfTheMasses) {
    std::mt19937_64 random(3);
    Workers workers(1);
    for (const auto& [name, lattice] : lattices()) {
        const Sites sites(lattice, uniform_points(lattice, 40, random()));
        Eigen::VectorXd weights = weights_of_size(40, 0.02, random);
        const Diagram here(sites, weights);
        if (!here.visible) continue;
        CellGraph graph;
        assemble_cell_graph(here.weighted(), orthocentre_heights(here.weighted(), workers), workers,
                            graph);
        const Eigen::VectorXd change = weights_of_size(40, 1, random);
        Eigen::VectorXd expected = Eigen::VectorXd::Zero(40);
        for (int s = 0; s < 40; ++s) {
            for (int k = graph.row_begin[s]; k < graph.row_begin[s + 1]; ++k) {
                expected[s] += graph.conductance[k] * (change[s] - change[graph.neighbour[k]]);
            }
        }
        constexpr double kStep = 1e-6;
        const auto mass = [&](double t) {
            return measured({sites, weights + t * change}, workers);
        };
        const Eigen::VectorXd difference = (mass(kStep).mass - mass(-kStep).mass) / (2 * kStep);
        const double unit = here.delaunay.spacing() * here.delaunay.spacing();
        EXPECT_LT((difference / unit - expected).norm(), 1e-5 * expected.norm()) << name;
    }
}

// Law 4.
TEST(PowerCells, EveryBitIsTheSameForAnyNumberOfWorkers) {
    std::mt19937_64 random(4);
    const Lattice unit = Lattice::rectangle(1, 1);
    const int n = 40'000;
    const Diagram diagram(Sites(unit, uniform_points(unit, n, 1)), weights_of_size(n, 0, random));
    Workers one(1);
    Workers three(3);
    const Energy first = measured(diagram, one);
    const Energy second = measured(diagram, three);
    EXPECT_EQ(first.value, second.value);
    EXPECT_EQ(first.mass, second.mass);
    EXPECT_EQ(first.gradient, second.gradient);
}

/// The changes of x_i m_i plus the first moment about x_i, for the cells as they are, and of m_i.
Eigen::VectorXd moment_changes(const Diagram& before, const Diagram& after,
                               const Eigen::VectorXd& dx, const Eigen::VectorXd& areas,
                               Workers& workers) {
    const Energy first = measured(before, workers);
    const Energy second = measured(after, workers);
    const auto n = first.mass.size();
    Eigen::VectorXd changes(4 * n);
    for (Eigen::Index s = 0; s < n; ++s) {
        changes.segment<2>(4 * s) = (first.gradient - second.gradient).segment<2>(2 * s) / 2 +
                                    areas[s] * dx.segment<2>(2 * s);
        changes[4 * s + 2] = second.mass[s] - first.mass[s];
        changes[4 * s + 3] = 0;
    }
    return changes;
}

// Law 5.
TEST(PowerCells, TheMatrixHasTheDerivativesOfTheMoments) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    Workers workers(1);
    for (const int n : {2, 40}) {
        for (const auto& [name, lattice] : lattices()) {
            SCOPED_TRACE(name + " " + std::to_string(n));
            const Sites sites(lattice, uniform_points(lattice, n, random()));
            const Eigen::VectorXd weights = weights_of_size(n, 0.02, random);
            const Diagram here(sites, weights);
            if (!here.visible) continue;
            const double h = here.delaunay.spacing();
            const Eigen::VectorXd dw = weights_of_size(n, 1, random);
            Eigen::VectorXd dx(2 * n);
            for (double& x : dx) x = h * normal(random);
            constexpr double kStep = 1e-6;
            const auto moved = [&](double t) {
                Points u = sites.coordinates();
                for (int s = 0; s < n; ++s) {
                    const Vec2 du = here.delaunay.frame().to_lattice(t * dx.segment<2>(2 * s));
                    u.col(here.delaunay.original_id(s)) +=
                        (du * 0x1p50).array().round().matrix() * 0x1p-50;
                }
                return Diagram(Sites(sites.lattice(), sites.reduction(), u), weights + t * dw);
            };
            const Eigen::VectorXd areas = measured(here, workers).mass;
            const Eigen::VectorXd difference =
                moment_changes(moved(-kStep), moved(kStep), 2 * kStep * dx, areas, workers) /
                (2 * kStep);
            BlockMatrix matrix;
            assemble_moment_derivatives(here.weighted(),
                                        orthocentre_heights(here.weighted(), workers), h, matrix);
            Eigen::VectorXd change(4 * n);
            for (int s = 0; s < n; ++s) {
                change.segment<4>(4 * s) << dx[2 * s], dx[2 * s + 1], dw[s] * h * h / 2 / h, 0;
            }
            Eigen::VectorXd product(4 * n);
            matrix.multiply(change, product, workers);
            for (int s = 0; s < n; ++s) product[4 * s + 2] /= h;
            EXPECT_LT((difference - product).norm(), 1e-5 * product.norm());
        }
    }
}

}  // namespace
}  // namespace pcvt::plane
