#pragma once

// The definitions of size_newton.hpp, for the files that instantiate it.

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesher/cells/laplacian_solver.hpp"
#include "mesher/cvt/size_newton.hpp"

namespace pcvt {
namespace detail {

/// The linear equations are solved to this relative residual at first. Near the solution they are
/// solved to a share of r^(3/2) where the last step lowered the error by the factor r, a little
/// less than the next step can lower it, or so far that the error of the least size meets the
/// tolerance, which suffices for the last step.
inline constexpr double kLoosest = 1e-2;
inline constexpr double kPerReduction = 0.5;
inline constexpr double kPerTolerance = 0.1;
inline constexpr double kTightest = 1e-8;
/// Errors above this, relative to the sizes, are far from the solution.
inline constexpr double kFar = 1e-4;
/// Coarse problems of an earlier step serve until the error is below this share of that step's, and
/// for good if that step's was below kFixedCoarse, relative to the sizes: setting them up takes as
/// long as 15 products.
inline constexpr double kCoarseRange = 0.25;
inline constexpr double kFixedCoarse = 0.1;
/// Where only steps below this are acceptable along an approximate solution, its error exceeds the
/// sizes of small cells, and it is solved again to a fraction of the residual.
inline constexpr double kShortForApproximate = 0x1p-6;
inline constexpr double kTighter = 1e-3;
/// Weights of an earlier call are of use if every cell has at least this share of its least target.
inline constexpr double kSmallestWarmCell = 0.1;
/// The first trial is this many times as long as the last step, at most the full one.
inline constexpr double kLonger = 4;
/// A step that is not acceptable is shortened by the first factor down to kLong, then halved.
inline constexpr double kShorter = 0.8;
inline constexpr double kLong = 0.25;
/// A step shorter than this makes no progress.
inline constexpr double kShortestStep = 0x1p-30;
/// Errors below this, relative to the sizes, or below a few roundings, may be rounding: steps are
/// judged by the largest error of a cell, and one that does not lower it ends the iteration.
inline constexpr double kRounding = 1e-9;
inline constexpr double kPerRounding = 4;
inline constexpr int kMostSteps = 200;

inline double largest_error(const Eigen::VectorXd& sizes, const Eigen::VectorXd& targets) {
    return ((sizes - targets).array().abs() / targets.array()).maxCoeff();
}

}  // namespace detail

template <class Diagram>
SizeNewton<Diagram>::SizeNewton(const Moving& moving, Workers& workers, WeightOrbits orbits)
    : orbits_(std::move(orbits)), here_(moving, workers), trial_(moving, workers) {}

/// r_i of each orbit, for one of its cells.
/// @param cells      the graph of the present weights.
/// @param of_weight  k 2^-53
template <class Diagram>
Eigen::VectorXd SizeNewton<Diagram>::orbit_roundings(const CellGraph& cells,
                                                     double of_weight) const {
    // The weights of an orbit are equal.
    const Eigen::VectorXd n_cells = orbits_.sums(Eigen::VectorXd::Ones(here_.n_sites()));
    const Eigen::VectorXd magnitude = orbits_.sums(weights().cwiseAbs()).cwiseQuotient(n_cells);
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(cells.n_rows());
    for (int s = 0; s < cells.n_rows(); ++s) {
        for (int k = cells.row_begin[s]; k < cells.row_begin[s + 1]; ++k) {
            sums[s] += cells.conductance[k] * (magnitude[s] + magnitude[cells.neighbour[k]]);
        }
    }
    return of_weight * sums.cwiseQuotient(n_cells);
}

template <class Diagram>
double SizeNewton<Diagram>::excess(const Eigen::VectorXd& sizes, const Eigen::VectorXd& targets,
                                   double tolerance) const {
    return ((sizes - targets).array().abs() / (tolerance * targets.array()).max(roundings_.array()))
        .maxCoeff();
}

/// Chooses the weights at which the iteration begins.
template <class Diagram>
void SizeNewton<Diagram>::begin(double least_target) {
    Eigen::VectorXd warm = warm_.size() > 0 ? warm_ : here_.weights();
    warm_.resize(0);
    if (warm.size() == here_.n_sites()) {
        for (int k = 0; k < Diagram::kWarmTrials; ++k) {
            here_.start();
            if (here_.set_weights(warm) &&
                here_.sizes().minCoeff() >= detail::kSmallestWarmCell * least_target) {
                return;
            }
            warm /= 2;
        }
    }
    here_.start();
    here_.set_weights(Eigen::VectorXd::Zero(here_.n_sites()));
}

/// The error of sizes, of which a step must lower its share.
template <class Diagram>
double SizeNewton<Diagram>::distance(const Iteration& now, const Eigen::VectorXd& sizes,
                                     bool is_far) const {
    if (!is_far) return (now.targets - sizes).norm();
    return (now.targets.cwiseSqrt() - sizes.cwiseSqrt()).norm();
}

/// The change of sizes that a full step aims at.
/// @param error  s - m
template <class Diagram>
Eigen::VectorXd SizeNewton<Diagram>::aim(const Iteration& now, const Eigen::VectorXd& error) const {
    if (error.norm() < detail::kFar * now.targets.norm()) return error;
    const Eigen::VectorXd mean = sizes().cwiseProduct(now.targets).cwiseSqrt();
    return 2 * (sizes().sum() / mean.sum() * mean - sizes());
}

/// Shortens the step along `direction` until it is acceptable, or shorter than `shortest`.
template <class Diagram>
typename SizeNewton<Diagram>::Outcome SizeNewton<Diagram>::search(Iteration& now,
                                                                  const Eigen::VectorXd& direction,
                                                                  double shortest) {
    const Eigen::VectorXd& targets = now.targets;
    const double norm = (targets - here_.sizes()).norm();
    const bool is_far = norm >= detail::kFar * targets.norm();
    const bool near = norm < std::max(detail::kRounding * targets.norm(),
                                      detail::kPerRounding * roundings_.norm());
    const double error = distance(now, here_.sizes(), is_far);
    const double here = near ? excess(here_.sizes(), targets, now.tolerance) : 0;
    double t = std::min(1.0, detail::kLonger * last_step_);
    for (; t >= shortest; t *= t > detail::kLong ? detail::kShorter : 0.5) {
        trial_.start(here_);
        // Round each weight once.
        const double mean = (here_.weights() + t * direction).mean();
        Eigen::VectorXd weights = here_.weights().array() + (t * direction.array() - mean);
        ++now.figures.trials;
        if (!trial_.set_weights(std::move(weights))) continue;
        if (!(trial_.sizes().minCoeff() >= now.least_size)) continue;
        const bool lower = distance(now, trial_.sizes(), is_far) <= (1 - t / 2) * error;
        // A cell of rounding size must not keep the error of others, nor the others that cell's.
        if (lower || (near && excess(trial_.sizes(), targets, now.tolerance) <=
                                  std::max(1.0, (1 - t / 2) * here))) {
            std::swap(here_, trial_);
            last_step_ = t;
            return Outcome::kAccepted;
        }
        if (near) return Outcome::kRounding;
    }
    return Outcome::kTooShort;
}

/// The relative residual to which the linear equations are solved at first.
/// @param error  |s - m|
template <class Diagram>
double SizeNewton<Diagram>::accuracy(const Iteration& now, double error) {
    if (now.figures.newton_steps == 0) return detail::kLoosest;
    const double reduction = error / now.last_error;
    const double next = detail::kPerReduction * reduction * std::sqrt(reduction);
    const double least_error =
        now.tolerance * now.targets.minCoeff() * std::sqrt(double(now.targets.size()));
    const double of_last = detail::kPerTolerance * least_error / error;
    return std::min(std::max(next, of_last), detail::kLoosest);
}

/// The solver of the next step.
/// @param error  |s - m|
template <class Diagram>
LaplacianSolver& SizeNewton<Diagram>::prepare(Iteration& now, const CellGraph& cells,
                                              double error) {
    if (now.solver_error < detail::kFixedCoarse * now.targets.norm() ||
        error > detail::kCoarseRange * now.solver_error) {
        now.solver->replace_finest(cells);
    } else {
        now.solver.emplace(cells);
        now.solver_error = error;
    }
    return *now.solver;
}

/// Takes one damped step; returns false if no step lowers the error.
template <class Diagram>
bool SizeNewton<Diagram>::step(Iteration& now) {
    const Eigen::VectorXd error = now.targets - here_.sizes();
    const CellGraph cells = graph();
    roundings_ = orbits_.spread(orbit_roundings(cells, Diagram::kAimedRounding));
    if (excess(here_.sizes(), now.targets, now.tolerance) <= 1) return false;
    LaplacianSolver& solver = prepare(now, cells, error.norm());
    const Eigen::VectorXd aim_of_orbits = orbits_.sums(aim(now, error));
    Eigen::VectorXd direction;
    for (double wanted = accuracy(now, error.norm());; wanted *= detail::kTighter) {
        const bool tightest = wanted <= detail::kTightest;
        now.figures.products +=
            solver.solve(aim_of_orbits, std::max(wanted, detail::kTightest), direction);
        const double shortest = tightest ? detail::kShortestStep : detail::kShortForApproximate;
        // What looks like rounding may be the error of the solution.
        const Outcome outcome = search(now, orbits_.spread(direction), shortest);
        if (outcome == Outcome::kAccepted) break;
        if (tightest) return false;
    }
    now.last_error = error.norm();
    return true;
}

template <class Diagram>
SizeFigures SizeNewton<Diagram>::solve(const Eigen::VectorXd& targets, double tolerance,
                                       const NewtonCallback& callback) {
    begin(targets.minCoeff());
    last_step_ = 1;
    Iteration now{.targets = targets,
                  .tolerance = tolerance,
                  .least_size = std::min(targets.minCoeff(), sizes().minCoeff()) / 2};
    SizeFigures& figures = now.figures;
    for (;;) {
        figures.largest_relative_error = detail::largest_error(sizes(), targets);
        figures.converged = figures.largest_relative_error <= tolerance;
        if (callback) callback(figures);
        if (figures.converged) return figures;
        if (figures.newton_steps == detail::kMostSteps) break;
        if (!step(now)) break;
        ++figures.newton_steps;
    }
    now.solver.reset();
    const Eigen::VectorXd bound = orbits_.spread(orbit_roundings(graph(), Diagram::kSizeRounding));
    figures.rounding = bound.cwiseQuotient(targets).maxCoeff();
    figures.converged =
        ((sizes() - targets).array().abs() <= (tolerance * targets.array()).max(bound.array()))
            .all();
    return figures;
}

}  // namespace pcvt
