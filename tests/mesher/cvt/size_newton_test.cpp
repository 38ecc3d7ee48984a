#include "mesher/cvt/size_newton.hpp"

#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

#include "mesher/cvt/size_newton_definitions.hpp"

namespace pcvt {
namespace {

/// Sites on a circle of length 1, in increasing order.
struct Circle {
    std::vector<double> at;

    int n_sites() const { return static_cast<int>(at.size()); }
    /// The way from a site to the next one.
    double gap(int s) const {
        return s + 1 < n_sites() ? at[s + 1] - at[s] : at.front() + 1 - at.back();
    }
};

/// The power diagram in one dimension: intervals between the sites, whose lengths are linear in the
/// weights.
class Intervals {
   public:
    using Moving = Circle;
    static constexpr double kSizeRounding = 0x1p-53;
    static constexpr double kAimedRounding = kSizeRounding;
    static constexpr int kWarmTrials = 1;

    Intervals(const Circle& circle, Workers&) : circle_(&circle) {}

    int n_sites() const { return circle_->n_sites(); }
    void start() {}
    void start(const Intervals&) {}
    bool set_weights(Eigen::VectorXd weights) {
        weights_ = std::move(weights);
        sizes_.setZero(n_sites());
        for (int s = 0; s < n_sites(); ++s) {
            const int t = (s + 1) % n_sites();
            const double reach = (weights_[s] - weights_[t]) / (2 * circle_->gap(s));
            sizes_[s] += circle_->gap(s) / 2 + reach;
            sizes_[t] += circle_->gap(s) / 2 - reach;
        }
        return sizes_.minCoeff() > 0;
    }
    const Eigen::VectorXd& weights() const { return weights_; }
    const Eigen::VectorXd& sizes() const { return sizes_; }
    CellGraph graph() const {
        CellGraph graph{{0}, {}, {}};
        const int n = n_sites();
        for (int s = 0; s < n; ++s) {
            for (const int gap : {(s + n - 1) % n, s}) {
                const int t = gap == s ? (s + 1) % n : gap;
                if (t == s) continue;
                graph.neighbour.push_back(t);
                graph.conductance.push_back(1 / (2 * circle_->gap(gap)));
            }
            graph.row_begin.push_back(static_cast<int>(graph.neighbour.size()));
        }
        return graph;
    }

   private:
    const Circle* circle_;
    Eigen::VectorXd weights_;
    Eigen::VectorXd sizes_;
};

Circle random_circle(int n, std::mt19937_64& random) {
    std::uniform_real_distribution<double> uniform;
    Circle circle;
    for (int s = 0; s < n; ++s) circle.at.push_back((s + 0.9 * uniform(random)) / n);
    return circle;
}

// Laws 1 and 2, in one dimension.
TEST(SizeNewton, ReachesLengthsOfIntervals) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0.2, 1);
    Workers workers(1);
    for (const int n : {1, 2, 3, 10, 300}) {
        const Circle circle = random_circle(n, random);
        Eigen::VectorXd targets(n);
        for (double& target : targets) target = uniform(random);
        targets /= targets.sum();
        SizeNewton<Intervals> newton(circle, workers);
        const SizeFigures figures = newton.solve(targets, 1e-10);
        EXPECT_TRUE(figures.converged) << n;
        EXPECT_LE(((newton.sizes() - targets).array() / targets.array()).abs().maxCoeff(), 1e-10);
        EXPECT_NEAR(newton.weights().sum(), 0, 1e-12) << n;
    }
}

// Law 4.
TEST(SizeNewton, KeepsTheWeightsOfAnOrbitEqual) {
    const Circle circle{{0, 0.2, 0.5, 0.7}};
    Workers workers(1);
    SizeNewton<Intervals> newton(circle, workers, WeightOrbits({0, 1, 0, 1}));
    EXPECT_TRUE(newton.solve(Eigen::Vector4d(0.3, 0.2, 0.3, 0.2), 1e-12).converged);
    EXPECT_EQ(newton.weights()[0], newton.weights()[2]);
    EXPECT_EQ(newton.weights()[1], newton.weights()[3]);
    EXPECT_GT(newton.weights()[0], newton.weights()[1]);
}

}  // namespace
}  // namespace pcvt
