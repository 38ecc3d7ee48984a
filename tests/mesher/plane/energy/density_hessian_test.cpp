#include "mesher/plane/energy/density_hessian.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesher/plane/density/density_survey.hpp"
#include "mesher/plane/energy/density_energy.hpp"
#include "mesher/plane/energy/hessian.hpp"
#include "tests/support/dense.hpp"
#include "tests/support/densities.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using testing::dense;

/// Sites drawn from a density, with fine rules.
class Place {
   public:
    Place(const Lattice& lattice, Density rho, int n)
        : density_(std::move(rho)),
          delaunay_(Sites(lattice, graded_points(lattice, density_, n, 5))),
          pass_(delaunay_, workers_, lattice, density_, 1) {
        EXPECT_TRUE(pass_.evaluate(energy_));
        pass_.choose_orders(1e-11, true);
        pass_.evaluate(energy_);
    }
    MatrixXd hessian() {
        BlockMatrix h;
        pass_.hessian(energy_.mass, h);
        return dense(h);
    }
    MatrixXd uniform_hessian() {
        BlockMatrix h;
        assemble_hessian(delaunay_, workers_, h);
        return dense(h);
    }
    /// The derivative of the gradient along `direction`, by central differences.
    VectorXd derivative(const Eigen::VectorXf& direction) {
        const double t = 1e-5 * delaunay_.spacing();
        return (gradient(direction, t) - gradient(direction, -t)) / (2 * t);
    }

   private:
    VectorXd gradient(const Eigen::VectorXf& direction, double t) {
        Energy there;
        delaunay_.step(direction, t, workers_);
        EXPECT_TRUE(pass_.evaluate(there));
        delaunay_.step_back();
        EXPECT_TRUE(pass_.evaluate(energy_));
        return there.gradient;
    }

    Workers workers_{1};
    Density density_;
    MovingDelaunay delaunay_;
    DensityPass pass_;
    Energy energy_;
};

/// A density of so small a contrast that the rule for edges is accurate even for few sites.
Density gentle_density() {
    return shared_density([](const DensityPoint& p) {
        return 2 + std::sin(2 * M_PI * p.u) * std::cos(2 * M_PI * p.v);
    });
}

// Law 1, also for few sites, whose cells have edges with their own images.
TEST(DensityHessian, IsTheDerivativeOfTheGradient) {
    const Lattice hexagonal({1, 0}, {0.5, std::sqrt(0.75)});
    for (const Lattice& lattice : {Lattice({1, 0}, {0.37, 0.81}), hexagonal}) {
        for (const auto& [n, accuracy] : {std::pair(1, 2e-2), {2, 2e-2}, {9, 1e-3}, {200, 1e-5}}) {
            SCOPED_TRACE(n);
            Place place(lattice, gentle_density(), n);
            const MatrixXd h = place.hessian();
            const Eigen::VectorXf direction =
                Eigen::VectorXf::LinSpaced(2 * n, 1, 40).array().sin();
            const VectorXd expected = place.derivative(direction);
            const VectorXd found = h * direction.cast<double>();
            EXPECT_LT((found - expected).norm(), accuracy * expected.norm());
        }
    }
}

TEST(DensityHessian, IsTheDerivativeOfTheGradientAcrossJumps) {
    Density board = testing::checkerboard();
    board.u_breaks = board.v_breaks = {0.5};
    for (const Density& density : {testing::ramp_density(), board}) {
        Place place(Lattice::rectangle(1, 1), density, 200);
        const Eigen::VectorXf direction = Eigen::VectorXf::LinSpaced(400, 1, 40).array().sin();
        const VectorXd expected = place.derivative(direction);
        const VectorXd found = place.hessian() * direction.cast<double>();
        EXPECT_LT((found - expected).norm(), 1e-4 * expected.norm());
    }
}

// Law 2.
TEST(DensityHessian, OfAConstantEqualsTheUniformHessian) {
    for (const auto& [name, lattice] : testing::lattices()) {
        for (const int n : {1, 3, 60}) {
            SCOPED_TRACE(name + ", n = " + std::to_string(n));
            Place place(lattice, shared_density([](const DensityPoint&) { return 3.0; }), n);
            const MatrixXd uniform = place.uniform_hessian();
            const double scale = n == 1 ? 1 : uniform.norm();
            EXPECT_LT((place.hessian() - 3 * uniform).norm(), 1e-5 * scale);
        }
    }
}

// Law 3.
TEST(DensityHessian, IsSymmetric) {
    Place place(Lattice({1, 0}, {0.37, 0.81}), testing::ridge_density(), 100);
    const MatrixXd h = place.hessian();
    EXPECT_LT((h - h.transpose()).norm(), 1e-6 * h.norm());
}

}  // namespace
}  // namespace pcvt::plane
