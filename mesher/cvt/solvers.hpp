#pragma once

#include <array>

#include "mesher/base/choices.hpp"
#include "mesher/optimize/lbfgs.hpp"
#include "mesher/optimize/lbfgs_newton.hpp"
#include "mesher/optimize/lloyd.hpp"

namespace pcvt {

/// `kLbfgs` lets Newton's method finish where a minimum is near and the objective has a Hessian,
/// `kNewton` uses that method from the start (lbfgs_newton.hpp). `kPlainLbfgs` and `kLloyd` are the
/// paper's solvers.
enum class Solver { kLbfgs, kLloyd, kNewton, kPlainLbfgs };

/// Minimises from the point that the objective holds.
using Minimize = OptimizerResult (*)(Objective&, const OptimizerOptions&, Workers&);

/// A solver in options, reports and runs.
///
///   const OptimizerResult end = solver_row(Solver::kLbfgs).minimize(objective, options, workers);
struct SolverRow {
    Solver solver;
    /// In options and reports.
    const char* word;
    /// PCVT_SOLVER_... of pcvt.h, or kNotOffered.
    int abi_value;
    /// For the command's help; may be empty.
    const char* help;
    Minimize minimize;
    /// With a density, where an evaluation costs far more than a product with the Hessian.
    Minimize minimize_density;
    /// Whether plane::CvtOptions::precondition_below applies.
    bool preconditions;
    /// Whether sites in space can have it.
    bool in_space;
};

namespace detail {

template <NewtonStart start>
OptimizerResult lbfgs_newton(Objective& objective, const OptimizerOptions& options,
                             Workers& workers) {
    return minimize_lbfgs_newton(objective, options, start, workers);
}

inline OptimizerResult lloyd(Objective& objective, const OptimizerOptions& options, Workers&) {
    return minimize_lloyd(objective, options);
}

}  // namespace detail

/// In the order of the enumerators. With a density Newton's method pays for any number of sites:
/// measured up to 10^5, where it halves the evaluations.
inline constexpr std::array kSolvers{
    SolverRow{.solver = Solver::kLbfgs,
              .word = "lbfgs",
              .abi_value = 1,
              .help = "lbfgs is finished by newton where that pays",
              .minimize = detail::lbfgs_newton<NewtonStart::kNear>,
              .minimize_density = detail::lbfgs_newton<NewtonStart::kNearForAnyNumber>,
              .preconditions = true,
              .in_space = true},
    SolverRow{.solver = Solver::kLloyd,
              .word = "lloyd",
              .abi_value = 2,
              .help = "",
              .minimize = detail::lloyd,
              .minimize_density = detail::lloyd,
              .preconditions = false,
              .in_space = true},
    SolverRow{.solver = Solver::kNewton,
              .word = "newton",
              .abi_value = 3,
              .help = "",
              .minimize = detail::lbfgs_newton<NewtonStart::kAtOnce>,
              .minimize_density = detail::lbfgs_newton<NewtonStart::kAtOnce>,
              .preconditions = true,
              .in_space = false},
    SolverRow{.solver = Solver::kPlainLbfgs,
              .word = "plain-lbfgs",
              .abi_value = kNotOffered,
              .help = "",
              .minimize = minimize_lbfgs,
              .minimize_density = minimize_lbfgs,
              .preconditions = false,
              .in_space = false}};

constexpr const SolverRow& solver_row(Solver solver) {
    return kSolvers[static_cast<std::size_t>(solver)];
}

}  // namespace pcvt
