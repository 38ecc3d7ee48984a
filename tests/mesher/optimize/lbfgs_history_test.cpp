#include "mesher/optimize/lbfgs_history.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <random>

namespace pcvt {
namespace {

using Eigen::VectorXd;

/// The relative error of a direction whose pairs are rounded to 16 bits.
constexpr double kRounding = 1e-3;

/// The gradient of a quadratic: a tridiagonal matrix with a random diagonal, positive definite.
class Quadratic {
   public:
    Quadratic(Eigen::Index n, std::uint64_t seed) : diagonal_(n) {
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> uniform(2.2, 9);
        for (double& d : diagonal_) d = uniform(random);
    }
    VectorXd gradient(const VectorXd& x) const {
        const Eigen::Index n = x.size();
        VectorXd g = diagonal_.cwiseProduct(x - VectorXd::Ones(n));
        g.head(n - 1) += x.tail(n - 1);
        g.tail(n - 1) += x.head(n - 1);
        return g;
    }

   private:
    VectorXd diagonal_;
};

/// The plain two-loop recursion (J. Nocedal 1980) in double precision.
class TwinHistory {
   public:
    explicit TwinHistory(std::size_t n_pairs) : n_pairs_(n_pairs) {}

    void add(const VectorXd& s, const VectorXd& y) {
        pairs_.push_back({s, y});
        if (pairs_.size() > n_pairs_) pairs_.pop_front();
    }
    VectorXd direction(const VectorXd& gradient) const {
        VectorXd q = gradient;
        std::vector<double> alpha(pairs_.size());
        for (std::size_t k = pairs_.size(); k-- > 0;) {
            const auto& [s, y] = pairs_[k];
            alpha[k] = s.dot(q) / s.dot(y);
            q -= alpha[k] * y;
        }
        q *= pairs_.back().s.dot(pairs_.back().y) / pairs_.back().y.squaredNorm();
        for (std::size_t k = 0; k < pairs_.size(); ++k) {
            const auto& [s, y] = pairs_[k];
            q += (alpha[k] - y.dot(q) / s.dot(y)) * s;
        }
        return -q;
    }

   private:
    struct Pair {
        VectorXd s;
        VectorXd y;
    };
    std::size_t n_pairs_;
    std::deque<Pair> pairs_;
};

Evaluation with_gradient(const VectorXd& gradient) {
    return {.gradient = gradient, .preconditioned = {}};
}

/// Walks through a quadratic along the history's directions.
class Walk {
   public:
    Walk(Eigen::Index n, std::uint64_t seed, Workers& workers)
        : quadratic(n, seed), history(n, workers) {
        std::mt19937_64 random(seed);
        std::normal_distribution<double> normal;
        x.resize(n);
        for (double& xi : x) xi = normal(random);
        gradient = quadratic.gradient(x);
        history.begin(with_gradient(gradient));
    }

    VectorXd direction() { return history.direction().cast<double>(); }
    LbfgsHistory::Direction compute_direction() {
        if (history.empty()) history.direction() = (-0.1 * gradient).cast<float>();
        return history.compute_direction();
    }
    void measure(const VectorXd& there) {
        history.directional_derivative(with_gradient(quadratic.gradient(there)));
    }
    /// Moves by t times the direction; returns the slope there.
    double advance(double t) {
        const VectorXd there = x + t * direction();
        const VectorXd gradient_there = quadratic.gradient(there);
        step = there - x;
        change = gradient_there - gradient;
        const double slope = history.directional_derivative(with_gradient(gradient_there));
        history.append_pair(t);
        x = there;
        gradient = gradient_there;
        return slope;
    }

    Quadratic quadratic;
    LbfgsHistory history;
    VectorXd x;
    VectorXd gradient;
    VectorXd step;
    VectorXd change;
};

/// Varying step lengths, so that steps and directions cannot be confused.
double step_length(int k) { return 0.4 + 0.3 * (k % 4); }

double largest_pair(const VectorXd& d) {
    return d.reshaped(2, d.size() / 2).colwise().norm().maxCoeff();
}

// The sizes cover one, two and many variables per lane, block and task.
TEST(LbfgsHistory, DirectionsMatchTheTwoLoopRecursion) {
    Workers workers(2);
    for (const Eigen::Index n : {2, 4, 6, 8, 10, 60, 2046, 2050, 32770, 70000}) {
        SCOPED_TRACE(n);
        Walk walk(n, 1, workers);
        TwinHistory twin(LbfgsHistory::kPairs);
        for (int k = 0; k < std::min<Eigen::Index>(n, 20); ++k) {
            const auto [slope, largest_move] = walk.compute_direction();
            const VectorXd d = walk.direction();
            if (k > 0) {
                const VectorXd expected = twin.direction(walk.gradient);
                ASSERT_LT((d - expected).norm(), kRounding * expected.norm()) << k;
            }
            ASSERT_NEAR(slope, walk.gradient.dot(d), 3e-5 * walk.gradient.norm() * d.norm());
            ASSERT_NEAR(largest_move, largest_pair(d), 1e-6 * d.norm());
            const double slope_there = walk.advance(step_length(k));
            ASSERT_NEAR(slope_there, walk.gradient.dot(d), 1e-6 * walk.gradient.norm() * d.norm());
            ASSERT_FALSE(walk.history.empty());
            twin.add(walk.step, walk.change);
        }
    }
}

// With the preconditioner D^2, D diagonal, this is the plain recursion in the variables D x.
TEST(LbfgsHistory, PreconditioningMatchesScaledVariables) {
    constexpr Eigen::Index kNumbers = 3000;
    Workers workers(1);
    const Quadratic quadratic(kNumbers, 8);
    const VectorXd scale = VectorXd::Random(kNumbers).array() / 2 + 1.5;
    const auto evaluate = [&](const VectorXd& x) {
        const VectorXd g = quadratic.gradient(x);
        return Evaluation{.gradient = g,
                          .preconditioned = g.cwiseQuotient(scale.cwiseAbs2()).cast<float>()};
    };
    LbfgsHistory history(kNumbers, workers);
    TwinHistory twin(LbfgsHistory::kPairs);
    Evaluation here = evaluate(VectorXd::Zero(kNumbers));
    history.begin(here);
    history.direction() = -here.preconditioned;
    VectorXd x = VectorXd::Zero(kNumbers);
    for (int k = 0; k < 12; ++k) {
        history.compute_direction();
        const VectorXd step = step_length(k) * history.direction().cast<double>();
        if (k > 0) {
            const VectorXd scaled = twin.direction(here.gradient.cwiseQuotient(scale));
            const VectorXd expected = step_length(k) * scaled.cwiseQuotient(scale);
            EXPECT_LT((step - expected).norm(), kRounding * expected.norm()) << k;
        }
        const Evaluation there = evaluate(x + step);
        history.directional_derivative(there);
        history.append_pair(step_length(k));
        twin.add(step.cwiseProduct(scale), (there.gradient - here.gradient).cwiseQuotient(scale));
        x += step;
        here = there;
    }
}

// A history with one pair more or fewer has a different direction.
TEST(LbfgsHistory, RemembersFivePairs) {
    EXPECT_EQ(LbfgsHistory::kPairs, 5);
    Workers workers(1);
    Walk walk(60, 2, workers);
    TwinHistory longer(6);
    TwinHistory shorter(4);
    for (int k = 0; k < 12; ++k) {
        walk.compute_direction();
        if (k > 7) {
            const VectorXd d = walk.direction();
            EXPECT_GT((d - longer.direction(walk.gradient)).norm(), 2 * kRounding * d.norm());
            EXPECT_GT((d - shorter.direction(walk.gradient)).norm(), 2 * kRounding * d.norm());
        }
        walk.advance(step_length(k));
        longer.add(walk.step, walk.change);
        shorter.add(walk.step, walk.change);
    }
}

// A trial that was measured but not accepted leaves no trace.
TEST(LbfgsHistory, IgnoresTrialsThatWereNotAccepted) {
    Workers workers(1);
    Walk straight(60, 3, workers);
    Walk hesitant(60, 3, workers);
    for (int k = 0; k < 10; ++k) {
        straight.compute_direction();
        hesitant.compute_direction();
        for (const double t : {3.0, 0.01}) {
            const VectorXd there = hesitant.x + t * hesitant.direction();
            hesitant.measure(there);
        }
        EXPECT_EQ(straight.advance(step_length(k)), hesitant.advance(step_length(k)));
        EXPECT_EQ(straight.x, hesitant.x);
    }
}

TEST(LbfgsHistory, ClearsAllPairsAtNegativeCurvature) {
    Workers workers(1);
    Walk walk(20, 4, workers);
    for (int k = 0; k < 3; ++k) {
        walk.compute_direction();
        walk.advance(1);
    }
    ASSERT_FALSE(walk.history.empty());
    walk.compute_direction();
    walk.history.directional_derivative(with_gradient(walk.gradient - walk.direction()));
    walk.history.append_pair(1);
    EXPECT_TRUE(walk.history.empty());
}

TEST(LbfgsHistory, ClearsAllPairsWhereTheSlopeChangesByLessThanAThousandth) {
    Workers workers(1);
    constexpr Eigen::Index kVariables = 60;
    for (const double length : {1e-9, 1.0, 1e9}) {
        for (const double part : {-1.0, 0.0, 0.9e-3, 1.1e-3, 1.0, 2.0}) {
            LbfgsHistory history(kVariables, workers);
            const VectorXd gradient = -length * VectorXd::Unit(kVariables, 0);
            history.begin(with_gradient(gradient));
            history.direction() = -gradient.cast<float>();
            history.compute_direction();
            history.directional_derivative(with_gradient((1 - part) * gradient));
            history.append_pair(0.5);
            EXPECT_EQ(history.empty(), part < 1e-3) << length << " " << part;
        }
    }
}

TEST(LbfgsHistory, ClearsAllPairsAtANewBeginning) {
    Workers workers(1);
    Walk walk(60, 5, workers);
    for (int k = 0; k < 9; ++k) {
        walk.compute_direction();
        walk.advance(step_length(k));
    }
    walk.history.begin(with_gradient(walk.gradient));
    EXPECT_TRUE(walk.history.empty());
    TwinHistory twin(LbfgsHistory::kPairs);
    for (int k = 0; k < 9; ++k) {
        walk.compute_direction();
        const VectorXd d = walk.direction();
        if (k > 0) {
            EXPECT_LT((d - twin.direction(walk.gradient)).norm(), kRounding * d.norm());
        }
        walk.advance(step_length(k));
        twin.add(walk.step, walk.change);
    }
}

TEST(LbfgsHistory, ComputesTheSameBitsForAnyNumberOfWorkers) {
    std::vector<VectorXd> reached;
    std::vector<double> slopes;
    for (const int n_threads : {1, 2, 3, 7}) {
        Workers workers(n_threads);
        Walk walk(200000, 6, workers);
        double slope = 0;
        for (int k = 0; k < 9; ++k) {
            walk.compute_direction();
            slope = walk.advance(step_length(k));
        }
        reached.push_back(walk.x);
        slopes.push_back(slope);
        EXPECT_EQ(reached.back(), reached.front());
        EXPECT_EQ(slopes.back(), slopes.front());
    }
}

}  // namespace
}  // namespace pcvt
