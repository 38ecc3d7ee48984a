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
/// solved to a multiple of the error, so that convergence stays quadratic, or so far that the error
/// of the least size meets the tolerance, which suffices for the last step.
inline constexpr double kLoosest = 1e-2;
inline constexpr double kPerError = 0.3;
inline constexpr double kPerTolerance = 0.1;
inline constexpr double kTightest = 1e-8;
/// Where only steps below this are acceptable along an approximate solution, its error exceeds the
/// sizes of small cells, and it is solved again to a fraction of the residual.
inline constexpr double kShortForApproximate = 0x1p-6;
inline constexpr double kTighter = 1e-3;
/// Weights of an earlier call are of use if every cell has at least this share of its least target.
inline constexpr double kSmallestWarmCell = 0.1;
/// The first trial is this many times as long as the last step, at most the full one.
inline constexpr double kLonger = 4;
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

/// Halves the step along `direction` until it is acceptable, or shorter than `shortest`.
template <class Diagram>
typename SizeNewton<Diagram>::Outcome SizeNewton<Diagram>::search(const Eigen::VectorXd& targets,
                                                                  const Eigen::VectorXd& direction,
                                                                  double tolerance, double shortest,
                                                                  double least_size,
                                                                  SizeFigures& figures) {
    const double error = (targets - here_.sizes()).norm();
    const bool near = error < std::max(detail::kRounding * targets.norm(),
                                       detail::kPerRounding * roundings_.norm());
    const double here = near ? excess(here_.sizes(), targets, tolerance) : 0;
    for (double t = std::min(1.0, detail::kLonger * last_step_); t >= shortest; t /= 2) {
        trial_.start(here_);
        // Round each weight once.
        const double mean = (here_.weights() + t * direction).mean();
        Eigen::VectorXd weights = here_.weights().array() + (t * direction.array() - mean);
        ++figures.trials;
        if (!trial_.set_weights(std::move(weights))) continue;
        if (!(trial_.sizes().minCoeff() >= least_size)) continue;
        const bool lower = (targets - trial_.sizes()).norm() <= (1 - t / 2) * error;
        // A cell of rounding size must not keep the error of others, nor the others that cell's.
        if (lower || (near && excess(trial_.sizes(), targets, tolerance) <=
                                  std::max(1.0, (1 - t / 2) * here))) {
            std::swap(here_, trial_);
            last_step_ = t;
            return Outcome::kAccepted;
        }
        if (near) return Outcome::kRounding;
    }
    return Outcome::kTooShort;
}

/// Takes one damped step; returns false if no step lowers the error.
template <class Diagram>
bool SizeNewton<Diagram>::step(const Eigen::VectorXd& targets, double tolerance, double least_size,
                               SizeFigures& figures) {
    const Eigen::VectorXd error = targets - here_.sizes();
    const Eigen::VectorXd error_of_orbits = orbits_.sums(error);
    const CellGraph cells = graph();
    roundings_ = orbits_.spread(orbit_roundings(cells, Diagram::kAimedRounding));
    if (excess(here_.sizes(), targets, tolerance) <= 1) return false;
    LaplacianSolver solver(cells, Diagram::kAggregation);
    Eigen::VectorXd direction;
    const double least_error = tolerance * targets.minCoeff() * std::sqrt(double(targets.size()));
    double accuracy = std::max(detail::kPerError * error.norm() / targets.norm(),
                               detail::kPerTolerance * least_error / error.norm());
    for (accuracy = std::min(accuracy, detail::kLoosest);; accuracy *= detail::kTighter) {
        const bool tightest = accuracy <= detail::kTightest;
        figures.products +=
            solver.solve(error_of_orbits, std::max(accuracy, detail::kTightest), direction);
        const double shortest = tightest ? detail::kShortestStep : detail::kShortForApproximate;
        // What looks like rounding may be the error of the solution.
        const Outcome outcome =
            search(targets, orbits_.spread(direction), tolerance, shortest, least_size, figures);
        if (outcome == Outcome::kAccepted) return true;
        if (tightest) return false;
    }
}

template <class Diagram>
SizeFigures SizeNewton<Diagram>::solve(const Eigen::VectorXd& targets, double tolerance,
                                       const NewtonCallback& callback) {
    begin(targets.minCoeff());
    last_step_ = 1;
    const double least_size = std::min(targets.minCoeff(), sizes().minCoeff()) / 2;
    SizeFigures figures;
    for (;;) {
        figures.largest_relative_error = detail::largest_error(sizes(), targets);
        figures.converged = figures.largest_relative_error <= tolerance;
        if (callback) callback(figures);
        if (figures.converged) return figures;
        if (figures.newton_steps == detail::kMostSteps) break;
        if (!step(targets, tolerance, least_size, figures)) break;
        ++figures.newton_steps;
    }
    const Eigen::VectorXd bound = orbits_.spread(orbit_roundings(graph(), Diagram::kSizeRounding));
    figures.rounding = bound.cwiseQuotient(targets).maxCoeff();
    figures.converged =
        ((sizes() - targets).array().abs() <= (tolerance * targets.array()).max(bound.array()))
            .all();
    return figures;
}

}  // namespace pcvt
