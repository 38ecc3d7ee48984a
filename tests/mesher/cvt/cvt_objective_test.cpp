#include "mesher/cvt/cvt_objective.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "mesher/plane/energy/energy.hpp"
#include "mesher/space/energy/energy_pass.hpp"

namespace pcvt {
namespace {

struct InPlane {
    using Pass = plane::EnergyPass;
    static std::int64_t flips_and_builds(const plane::MovingDelaunay& moving) {
        return moving.counts().n_flips + moving.counts().n_rebuilds;
    }
    static plane::MovingDelaunay moving(int n) {
        const plane::Lattice lattice({1, 0}, {0.3, 1.1});
        return plane::MovingDelaunay(plane::Sites(lattice, plane::uniform_points(lattice, n, 1)));
    }
};

struct InSpace {
    using Pass = space::EnergyPass;
    static std::int64_t flips_and_builds(const space::MovingTetrahedra& moving) {
        return moving.n_flips() + moving.n_rebuilds();
    }
    static space::MovingTetrahedra moving(int n) {
        const space::Lattice lattice({1, 0, 0}, {0.3, 1.1, 0}, {0.1, 0.2, 0.9});
        return space::MovingTetrahedra(space::Sites(lattice, space::uniform_points(lattice, n, 1)));
    }
};

/// The first coordinate of a site stays below a bound.
template <class Moving>
class Bound final : public SiteGuard<Moving> {
   public:
    explicit Bound(double greatest) : greatest_(greatest) {}
    bool admits(const Moving& moving) override {
        ++n_calls;
        return moving.coordinates()(0, 0) <= greatest_;
    }
    int n_calls = 0;

   private:
    double greatest_;
};

template <class Dimension>
class CvtObjectives : public ::testing::Test {
   protected:
    using Pass = typename Dimension::Pass;
    using Moving = typename Pass::Moving;

    /// Moves of up to `size` spacings along each axis.
    Eigen::VectorXf random_direction(double size) {
        std::uniform_real_distribution<double> uniform(-1, 1);
        Eigen::VectorXf direction =
            Eigen::VectorXf::Zero(Moving::kNumbersPerSite * Eigen::Index{moving_.n_sites()});
        for (Eigen::Index s = 0; s < moving_.n_sites(); ++s) {
            for (int k = 0; k < Moving::kDimension; ++k) {
                direction[Moving::kNumbersPerSite * s + k] =
                    static_cast<float>(size * moving_.spacing() * uniform(random_));
            }
        }
        return direction;
    }

    std::mt19937_64 random_{1};
    Workers workers_{2};
    Moving moving_ = Dimension::moving(60);
    SiteConstraints<Moving> constraints_;
};

using Dimensions = ::testing::Types<InPlane, InSpace>;
TYPED_TEST_SUITE(CvtObjectives, Dimensions);

TYPED_TEST(CvtObjectives, HaveTheGradientOfTheirValue) {
    CvtObjective<typename TypeParam::Pass> objective(this->moving_, this->workers_,
                                                     this->constraints_);
    const Eigen::VectorXf direction = this->random_direction(1);
    Evaluation here;
    ASSERT_TRUE(objective.evaluate(direction, 0, here));
    EXPECT_EQ(here.gradient.size(), objective.n_variables());
    constexpr double kStep = 1e-5;
    double difference = 0;
    for (const double t : {-kStep, kStep}) {
        Evaluation there;
        ASSERT_TRUE(objective.evaluate(direction, t, there));
        difference += (t < 0 ? -1 : 1) * there.value / (2 * kStep);
    }
    const double slope = here.gradient.dot(direction.template cast<double>());
    EXPECT_NEAR(difference / slope, 1, 1e-6);
}

TYPED_TEST(CvtObjectives, AreWhereTheyWereAfterARejectedTrial) {
    CvtObjective<typename TypeParam::Pass> objective(this->moving_, this->workers_,
                                                     this->constraints_);
    const auto coordinates = this->moving_.coordinates();
    Evaluation here;
    ASSERT_TRUE(objective.evaluate({}, 0, here));
    for (const double size : {1e-3, 0.1, 1.0}) {
        const Eigen::VectorXf direction = this->random_direction(size);
        Evaluation there;
        ASSERT_TRUE(objective.evaluate(direction, 1, there));
        EXPECT_NE(there.value, here.value);
        if (size == 0.1) {
            // A step that fails leaves the tetrahedra of the trial before it.
            const Eigen::VectorXf nowhere = Eigen::VectorXf::Constant(
                direction.size(), std::numeric_limits<float>::quiet_NaN());
            EXPECT_FALSE(objective.evaluate(nowhere, 1, there));
        }
        objective.reject();
        EXPECT_TRUE(this->moving_.settled());
        // Whole periods may have been taken off.
        const auto change = this->moving_.coordinates() - coordinates;
        EXPECT_EQ(change, change.array().round().matrix());
        // The triangulation is restored: another pass over it flips nothing, and finds the same F.
        const auto flips = TypeParam::flips_and_builds(this->moving_);
        typename TypeParam::Pass pass(this->moving_, this->workers_);
        Energy energy;
        ASSERT_TRUE(pass.evaluate(energy));
        EXPECT_EQ(TypeParam::flips_and_builds(this->moving_), flips);
        EXPECT_NEAR(energy.value / here.value, 1, 1e-13);
    }
}

TYPED_TEST(CvtObjectives, LloydStepsLeadToCentroids) {
    CvtObjective<typename TypeParam::Pass> objective(this->moving_, this->workers_,
                                                     this->constraints_);
    Evaluation here;
    Eigen::VectorXf step;
    ASSERT_TRUE(objective.evaluate({}, 0, here));
    double last = here.value;
    for (int k = 0; k < 5; ++k) {
        objective.lloyd_step(here, step);
        const Eigen::Map<const Eigen::MatrixXf> moves(step.data(), this->moving_.kNumbersPerSite,
                                                      this->moving_.n_sites());
        EXPECT_NEAR(moves.colwise().norm().maxCoeff() / this->moving_.spacing(), here.residual,
                    1e-6 * here.residual);
        ASSERT_TRUE(objective.evaluate(step, 1, here));
        objective.accept();
        EXPECT_LT(here.value, last);
        last = here.value;
    }
}

TYPED_TEST(CvtObjectives, KeepFixedSitesAndCallTheGuard) {
    using Triangulation = typename TypeParam::Pass::Moving;
    std::vector<bool> is_fixed(static_cast<std::size_t>(this->moving_.n_sites()), false);
    is_fixed[7] = is_fixed[11] = true;
    this->constraints_.fixed = FixedBlocks(is_fixed, Triangulation::kNumbersPerSite);
    Bound<Triangulation> guard(this->moving_.coordinates()(0, 0));
    this->constraints_.guard = &guard;
    CvtObjective<typename TypeParam::Pass> objective(this->moving_, this->workers_,
                                                     this->constraints_);
    Evaluation here;
    ASSERT_TRUE(objective.evaluate({}, 0, here));
    EXPECT_EQ(guard.n_calls, 0);
    for (const int s : {7, 11}) {
        for (int k = 0; k < Triangulation::kNumbersPerSite; ++k) {
            EXPECT_EQ(here.gradient[Triangulation::kNumbersPerSite * s + k], 0);
        }
    }
    Eigen::VectorXf direction = Eigen::VectorXf::Zero(objective.n_variables());
    direction[0] = static_cast<float>(0.1 * this->moving_.spacing());
    EXPECT_FALSE(objective.evaluate(direction, 1, here));
    EXPECT_TRUE(objective.evaluate(direction, -1, here));
    EXPECT_EQ(guard.n_calls, 2);
}

}  // namespace
}  // namespace pcvt
