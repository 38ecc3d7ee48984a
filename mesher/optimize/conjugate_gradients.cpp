#include "mesher/optimize/conjugate_gradients.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcvt {
namespace {

constexpr int kRowsPerTask = 1 << 13;
/// A diagonal block whose determinant is below this fraction of its squared trace is replaced by a
/// multiple of the identity: the preconditioner must be safely positive definite.
constexpr double kLeastDeterminant = 1e-3;

using Pair = Eigen::Vector2d;

/// The inverse of `block` or of its replacement, which uses `usual_trace` where the trace of the
/// block is not positive.
BlockMatrix::Block safe_inverse(const BlockMatrix::DiagonalBlock& block, double usual_trace) {
    const auto [xx, yx, xy, yy] = block;
    const double trace = xx + yy;
    const double determinant = xx * yy - xy * yx;
    if (trace > 0 && determinant > kLeastDeterminant * trace * trace) {
        const auto mixed = static_cast<float>(-xy / determinant);
        return {static_cast<float>(yy / determinant), mixed, mixed,
                static_cast<float>(xx / determinant)};
    }
    const auto scale = static_cast<float>(2 / (trace > 0 ? trace : usual_trace));
    return {scale, 0, 0, scale};
}

double mean_size(const std::vector<BlockMatrix::DiagonalBlock>& blocks) {
    double sum = 0;
    for (const BlockMatrix::DiagonalBlock& block : blocks)
        sum += std::abs(block[0]) + std::abs(block[3]);
    return sum > 0 ? sum / static_cast<double>(blocks.size()) : 1;
}

}  // namespace

/// A sum, a maximum, a minimum and a sum of pairs over the rows.
struct ConjugateGradients::Sums {
    double sum = 0;
    double largest = 0;
    double smallest = std::numeric_limits<double>::infinity();
    Pair pair = Pair::Zero();

    void add(const Sums& other) {
        sum += other.sum;
        largest = std::max(largest, other.largest);
        smallest = std::min(smallest, other.smallest);
        pair += other.pair;
    }
};

ConjugateGradients::ConjugateGradients(Eigen::Index n_variables, Workers& workers)
    : workers_(workers),
      solution_(n_variables),
      residual_(n_variables),
      direction_(n_variables),
      product_(n_variables),
      preconditioner_(static_cast<std::size_t>(n_variables / 2)) {}

/// Runs task(first variable of the row, sums) on all rows.
template <class Task>
ConjugateGradients::Sums ConjugateGradients::sweep(const Task& task) {
    const auto n_rows = static_cast<int>(preconditioner_.size());
    const int n_tasks = (n_rows + kRowsPerTask - 1) / kRowsPerTask;
    std::vector<Sums> sums(static_cast<std::size_t>(n_tasks));
    workers_.for_each(n_tasks, [&](int k) {
        const int end = std::min((k + 1) * kRowsPerTask, n_rows);
        Sums part;
        for (Eigen::Index row = k * kRowsPerTask; row < end; ++row) task(2 * row, part);
        sums[k] = part;
    });
    Sums total;
    for (const Sums& part : sums) total.add(part);
    return total;
}

/// Returns the preconditioned residual in the row of variable i.
Pair ConjugateGradients::preconditioned(Eigen::Index i) const {
    const BlockMatrix::Block& m = preconditioner_[i / 2];
    const double x = residual_[i];
    const double y = residual_[i + 1];
    return {m[0] * x + m[2] * y, m[1] * x + m[3] * y};
}

/// Starts at zero; returns the squared norm of the residual in the preconditioner's norm.
double ConjugateGradients::start(const BlockMatrix& h, const Eigen::VectorXd& gradient) {
    const double trace = mean_size(h.diagonal);
    return sweep([&](Eigen::Index i, Sums& part) {
               preconditioner_[i / 2] = safe_inverse(h.diagonal[i / 2], trace);
               solution_.segment<2>(i).setZero();
               residual_.segment<2>(i) = -gradient.segment<2>(i);
               const Pair z = preconditioned(i);
               direction_.segment<2>(i) = z;
               part.sum += z.dot(residual_.segment<2>(i));
           })
        .sum;
}

/// Moves the solution by alpha along the direction; returns the squared norm of the residual in the
/// preconditioner's norm, and the largest squared length of a pair of the solution.
ConjugateGradients::Sums ConjugateGradients::advance(double alpha) {
    return sweep([&](Eigen::Index i, Sums& part) {
        solution_.segment<2>(i) += alpha * direction_.segment<2>(i);
        residual_.segment<2>(i) -= alpha * product_.segment<2>(i);
        part.sum += preconditioned(i).dot(residual_.segment<2>(i));
        part.largest = std::max(part.largest, solution_.segment<2>(i).squaredNorm());
    });
}

void ConjugateGradients::turn(double beta) {
    sweep([&](Eigen::Index i, Sums&) {
        direction_.segment<2>(i) = preconditioned(i) + beta * direction_.segment<2>(i);
    });
}

/// The step along the direction at which the first pair reaches the radius.
double ConjugateGradients::longest_step(double radius) {
    const double smallest = sweep([&](Eigen::Index i, Sums& part) {
                                const Pair x = solution_.segment<2>(i);
                                const Pair p = direction_.segment<2>(i);
                                const double remaining =
                                    std::max(0.0, radius * radius - x.squaredNorm());
                                const double xp = x.dot(p);
                                const double pp = p.squaredNorm();
                                const double step = (std::sqrt(xp * xp + pp * remaining) - xp) / pp;
                                if (pp > 0) part.smallest = std::min(part.smallest, step);
                            }).smallest;
    return std::isfinite(smallest) ? smallest : 0;
}

/// Runs conjugate gradients; returns whether they ended at the boundary of the trust region.
bool ConjugateGradients::truncated_run(const BlockMatrix& h, const Limits& limits, double rz,
                                       int& products) {
    const double converged_below = limits.relative_residual * limits.relative_residual * rz;
    while (rz > converged_below && products < limits.products) {
        const double curvature = h.multiply(direction_, product_, workers_);
        ++products;
        if (!(curvature > 0)) {
            advance(longest_step(limits.radius));
            return true;
        }
        const double alpha = rz / curvature;
        const Sums there = advance(alpha);
        if (!(there.largest <= limits.radius * limits.radius)) {
            advance(-alpha);
            advance(longest_step(limits.radius));
            return true;
        }
        turn(there.sum / rz);
        rz = there.sum;
    }
    return false;
}

void ConjugateGradients::remove_mean() {
    const Pair total =
        sweep([&](Eigen::Index i, Sums& part) { part.pair += solution_.segment<2>(i); }).pair;
    const Pair mean = total / static_cast<double>(preconditioner_.size());
    sweep([&](Eigen::Index i, Sums&) { solution_.segment<2>(i) -= mean; });
}

ConjugateGradients::Outcome ConjugateGradients::solve(const BlockMatrix& h,
                                                      const Eigen::VectorXd& gradient,
                                                      const Limits& limits) {
    Outcome outcome{};
    const double rz = start(h, gradient);
    outcome.truncated = truncated_run(h, limits, rz, outcome.products);
    if (h.annihilates_translations) remove_mean();
    // H d = -g - r, so m(d) = (g - r).d / 2.
    const Sums sums = sweep([&](Eigen::Index i, Sums& part) {
        const Pair d = solution_.segment<2>(i);
        part.sum += (gradient.segment<2>(i) - residual_.segment<2>(i)).dot(d);
        part.largest = std::max(part.largest, d.squaredNorm());
    });
    outcome.model = sums.sum / 2;
    outcome.largest_move = std::sqrt(sums.largest);
    return outcome;
}

}  // namespace pcvt
