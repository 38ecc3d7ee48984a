#pragma once

#include <cmath>

#include "mesher/base/workers.hpp"
#include "mesher/cvt/energy.hpp"
#include "mesher/cvt/residuals.hpp"
#include "mesher/cvt/run_options.hpp"
#include "mesher/cvt/site_constraints.hpp"
#include "mesher/optimize/objective.hpp"

namespace pcvt {

/// The longest move of a site in one step, in units of h. Beyond it a site leaves its
/// neighbourhood, where the optimiser's quadratic model holds.
inline constexpr double kLargestMove = 0.5;

/// The CVT energy as a function of moving sites, in the plane and in space. It works in the frame
/// and the unit of the moving triangulation, so that the optimiser's products and thresholds do not
/// depend on the user's unit.
///
/// `Pass` evaluates the energy of a moving triangulation `Pass::Moving` (moving_delaunay.hpp,
/// moving_tetrahedra.hpp) and restores it after a step: plane::EnergyPass or space::EnergyPass.
///
/// Example usage:
///
///     Workers workers(1);
///     const SiteConstraints<MovingDelaunay> none;
///     CvtObjective<EnergyPass> objective(moving, workers, none);
///     minimize_lbfgs(objective, {.max_move = longest_move(moving)}, workers);
///     objective.reject();  // the triangulation is that of the result
template <class Pass>
class CvtObjective : public Objective {
   public:
    using Moving = typename Pass::Moving;

    /// All arguments must outlive this object.
    CvtObjective(Moving& moving, Workers& workers, const SiteConstraints<Moving>& constraints)
        : moving_(moving), workers_(workers), constraints_(constraints), pass_(moving, workers) {}

    Eigen::Index n_variables() const override {
        return Moving::kNumbersPerSite * Eigen::Index{moving_.n_sites()};
    }

    bool evaluate(const Eigen::VectorXf& direction, double t, Evaluation& evaluation) override {
        energy_.gradient.swap(evaluation.gradient);
        const bool defined = leave_trial() && try_step(direction, t);
        energy_.gradient.swap(evaluation.gradient);
        if (!defined) return false;
        constraints_.fixed.clear(evaluation.gradient);
        const auto [largest, rms] =
            residuals(evaluation.gradient, energy_.mass, moving_.spacing(), workers_);
        evaluation.value = energy_.value;
        evaluation.residual = largest;
        evaluation.rms_residual = constraints_.fixed.rms_factor() * rms;
        return true;
    }

    void accept() override { moving_.settle(); }
    void reject() override {
        if (moving_.settled()) return;
        moving_.step_back();
        pass_.evaluate(energy_);
    }

    void lloyd_step(const Evaluation& evaluation, Eigen::VectorXf& direction) const override {
        steps_to_centroids(evaluation.gradient, energy_.mass, direction);
    }

   protected:
    Moving& moving() const { return moving_; }
    Workers& workers() const { return workers_; }
    const SiteConstraints<Moving>& constraints() const { return constraints_; }
    /// The masses of the cells at the point evaluated last.
    const Eigen::VectorXd& mass() const { return energy_.mass; }

   private:
    /// Undoes a trial that was not accepted, as far as the next step requires.
    bool leave_trial() {
        if constexpr (Moving::kStepsUnrestored) {
            if (!moving_.settled()) moving_.step_back();
            return true;
        } else {
            if (moving_.settled()) return true;
            moving_.step_back();
            return pass_.evaluate(energy_);
        }
    }

    bool try_step(const Eigen::VectorXf& direction, double t) {
        if (t != 0) {
            if (!moving_.step(direction, t, workers_)) {
                // Where steps begin unrestored, the tetrahedra are those of the trial before.
                if constexpr (Moving::kStepsUnrestored) pass_.evaluate(energy_);
                return false;
            }
            if (!constraints_.admit(moving_)) return false;
        }
        return pass_.evaluate(energy_);
    }

    Moving& moving_;
    Workers& workers_;
    const SiteConstraints<Moving>& constraints_;
    Pass pass_;
    Energy energy_;
};

/// OptimizerOptions::max_move for which no site moves further than kLargestMove h in one step.
/// Optimisers limit the moves of pairs of variables; a site of four numbers is two pairs.
template <class Moving>
double longest_move(const Moving& moving) {
    constexpr double kPairsPerSite = Moving::kNumbersPerSite / 2.0;
    return std::sqrt(1 / kPairsPerSite) * kLargestMove * moving.spacing();
}

/// The options of the optimiser for a run in which no site moves further than kLargestMove h in one
/// step.
template <class Moving>
OptimizerOptions optimizer_options(const Moving& moving, const RunOptions& run) {
    return {.tolerance = run.tolerance,
            .max_iterations = run.max_iterations,
            .max_move = longest_move(moving),
            .progress = run.progress};
}

/// Minimises the energy of moving sites by one of the solvers of solvers.hpp.
/// @param options  progress reports values in length units.
/// @returns the figures of the run, with the energy in length units.
template <class Moving>
RunStatistics minimize_energy(const Moving& moving, Objective& objective, Minimize minimize,
                              OptimizerOptions options, Workers& workers) {
    const double value_unit = std::pow(moving.unit(), Moving::kDimension + 2);
    if (options.progress) {
        options.progress = [value_unit, report = options.progress](Progress progress) {
            progress.value *= value_unit;
            return report(progress);
        };
    }
    RunStatistics run = minimize(objective, options, workers).run;
    run.energy *= value_unit;
    return run;
}

}  // namespace pcvt
