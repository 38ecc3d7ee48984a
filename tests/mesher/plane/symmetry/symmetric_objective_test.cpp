#include "mesher/plane/symmetry/symmetric_objective.hpp"

#include <gtest/gtest.h>

#include <random>

#include "mesher/cvt/residuals.hpp"
#include "mesher/plane/energy/energy.hpp"
#include "mesher/plane/energy/hessian.hpp"
#include "tests/support/dense.hpp"
#include "tests/support/energy_at.hpp"
#include "tests/support/symmetry.hpp"

namespace pcvt::plane {
namespace {

using Eigen::VectorXd;
using Eigen::VectorXf;

/// The energy of all sites as an objective, as compute_cvt has it.
class AllSites final : public Objective {
   public:
    explicit AllSites(MovingDelaunay& delaunay) : delaunay_(delaunay), pass_(delaunay, workers_) {}

    Eigen::Index n_variables() const override { return 2 * Eigen::Index{delaunay_.n_sites()}; }
    bool evaluate(const VectorXf& direction, double t, Evaluation& evaluation) override {
        reject();
        if (t != 0 && !delaunay_.step(direction, t, workers_)) return false;
        if (!pass_.evaluate(energy_)) return false;
        evaluation.value = energy_.value;
        evaluation.gradient = energy_.gradient;
        return true;
    }
    void accept() override { delaunay_.settle(); }
    void reject() override {
        if (delaunay_.settled()) return;
        delaunay_.step_back();
        pass_.evaluate(energy_);
    }
    void lloyd_step(const Evaluation& evaluation, VectorXf& direction) const override {
        steps_to_centroids(evaluation.gradient, energy_.mass, direction);
    }
    bool has_hessian() const override { return true; }
    void hessian(BlockMatrix& hessian) const override {
        assemble_hessian(delaunay_, workers_, hessian);
    }

   private:
    mutable Workers workers_{1};
    MovingDelaunay& delaunay_;
    EnergyPass pass_;
    Energy energy_;
};

/// Orbits of every kind: three in general positions, one on each mirror, and all centres.
SymmetricSites sites_of(PlaneGroupName name) {
    const PlaneGroup group(name, testing::fitting_lattice(name));
    const SpecialPositions special = special_positions(group);
    return random_sites(group,
                        {3, std::vector<int>(special.mirrors.size(), 1),
                         std::vector<bool>(special.centres.size(), true)},
                        7);
}

VectorXf random_direction(Eigen::Index n, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<float> normal;
    return VectorXf::NullaryExpr(n, [&] { return normal(random); });
}

// Law (2) for the gradient.
TEST(SymmetricObjective, HasTheGradientOfItsValue) {
    for (const PlaneGroupRow& row : kPlaneGroups) {
        const SymmetricSites sites = sites_of(row.name);
        MovingDelaunay delaunay(sites.sites);
        AllSites all(delaunay);
        SymmetricObjective objective(all, tie_orbits(sites, delaunay));
        Evaluation here, ahead, behind;
        for (int k = 0; k < 5; ++k) {
            const VectorXf d = random_direction(objective.n_variables(), k);
            ASSERT_TRUE(objective.evaluate(d, 0, here));
            const double t = 1e-5 * delaunay.spacing();
            ASSERT_TRUE(objective.evaluate(d, t, ahead));
            ASSERT_TRUE(objective.evaluate(d, -t, behind));
            const double slope = here.gradient.dot(d.cast<double>());
            EXPECT_NEAR((ahead.value - behind.value) / (2 * t), slope,
                        1e-5 * here.gradient.norm() * d.norm())
                << row.word;
            objective.reject();
        }
    }
}

// Law (2) for the Hessian.
TEST(SymmetricObjective, HasTheHessianOfItsValue) {
    for (const PlaneGroupRow& row : kPlaneGroups) {
        const SymmetricSites sites = sites_of(row.name);
        MovingDelaunay delaunay(sites.sites);
        AllSites all(delaunay);
        SymmetricObjective objective(all, tie_orbits(sites, delaunay));
        Evaluation here, ahead, behind;
        // Random sites may lie so close together that differences are coarse.
        VectorXf step;
        for (int k = 0; k < 3; ++k) {
            ASSERT_TRUE(objective.evaluate(step, 0, here));
            objective.lloyd_step(here, step);
            ASSERT_TRUE(objective.evaluate(step, 1, here));
            objective.accept();
        }
        BlockMatrix hessian;
        ASSERT_TRUE(objective.evaluate(step, 0, here));
        objective.hessian(hessian);
        const Eigen::MatrixXd matrix = testing::dense(hessian);
        EXPECT_LT((matrix - matrix.transpose()).norm(), 1e-6 * matrix.norm()) << row.word;
        const VectorXf d = random_direction(objective.n_variables(), 1);
        const double t = 1e-6 * delaunay.spacing();
        ASSERT_TRUE(objective.evaluate(d, t, ahead));
        ASSERT_TRUE(objective.evaluate(d, -t, behind));
        const VectorXd change = (ahead.gradient - behind.gradient) / (2 * t);
        EXPECT_LT((change - matrix * d.cast<double>()).norm(), 1e-5 * matrix.norm() * d.norm())
            << row.word;
        objective.reject();
    }
}

// Law (1), and each site at its centroid follows from only the representatives.
TEST(SymmetricObjective, HasTheValueOfAllSitesAndFoldsTheLloydStep) {
    for (const PlaneGroupRow& row : kPlaneGroups) {
        const SymmetricSites sites = sites_of(row.name);
        MovingDelaunay delaunay(sites.sites);
        AllSites all(delaunay);
        SymmetricObjective objective(all, tie_orbits(sites, delaunay));
        Evaluation here;
        VectorXf step;
        ASSERT_TRUE(objective.evaluate(step, 0, here));
        objective.lloyd_step(here, step);
        ASSERT_TRUE(objective.evaluate(step, 1, here));
        objective.accept();
        const auto [moved, triangulation] = delaunay.release();
        testing::expect_symmetric(sites, moved);
        const testing::PlaneEnergy before = testing::energy_at(sites.sites);
        const testing::PlaneEnergy now = testing::energy_at(moved);
        EXPECT_LT(now.value, before.value);
        EXPECT_NEAR(here.value * std::pow(delaunay.unit(), 4) / now.value, 1, 1e-14) << row.word;
        const double h = moved.spacing();
        for (SiteId s = 0; s < moved.n_sites(); ++s) {
            const Vec2 target =
                sites.sites.position(s) - before.gradient.col(s) / (2 * before.mass[s]);
            const Lattice& lattice = moved.reduction().reduced;
            Vec2 periods = lattice.to_lattice(moved.position(s) - target);
            periods.array() -= periods.array().round();
            EXPECT_LT(lattice.to_position(periods).norm(), 1e-6 * h) << row.word << " site " << s;
        }
    }
}

}  // namespace
}  // namespace pcvt::plane
