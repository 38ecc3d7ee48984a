#include "mesher/areas/area_cvt.hpp"

#include <cmath>

#include "mesher/base/error.hpp"
#include "mesher/energy/energy.hpp"
#include "mesher/energy/residuals.hpp"
#include "mesher/optimize/lbfgs.hpp"
#include "mesher/power/power_flips.hpp"

namespace pcvt {
namespace {

/// The longest move of a site in one step, in units of h.
constexpr double kLargestMove = 0.5;
/// The areas of a trial position must be more exact than those of a result, so that the energy
/// decreases along the gradient.
constexpr double kTrialTolerance = 0.1;

/// The energy of the cells of prescribed areas as a function of moving sites, in the frame and unit
/// of the triangulation.
class AreaObjective final : public Objective {
   public:
    AreaObjective(MovingDelaunay& delaunay, const Eigen::VectorXd& areas,
                  const NewtonCallback& callback, Workers& workers)
        : delaunay_(delaunay),
          areas_(areas),
          callback_(callback),
          workers_(workers),
          pass_(delaunay, workers),
          newton_(delaunay, workers) {}

    Eigen::Index n_variables() const override { return 2 * Eigen::Index{delaunay_.n_sites()}; }

    bool evaluate(const Eigen::VectorXf& direction, double t, Evaluation& evaluation) override {
        if (!undo_step()) return false;
        if (t != 0 && !delaunay_.step(direction, t, workers_)) return false;
        if (!pass_.evaluate(euclidean_)) return false;
        measure();
        const auto [largest, rms] =
            residuals(cells_.gradient, cells_.mass, delaunay_.spacing(), workers_);
        // g(w): its error is quadratic in that of the areas, that of the energy is linear.
        evaluation.value = cells_.energy + newton_.weights().dot(areas_ - cells_.mass);
        evaluation.gradient = cells_.gradient;
        evaluation.residual = largest;
        evaluation.rms_residual = rms;
        return true;
    }

    void accept() override { delaunay_.settle(); }
    void reject() override { undo_step(); }

    void lloyd_step(const Evaluation& evaluation, Eigen::VectorXf& direction) const override {
        steps_to_centroids(evaluation.gradient, cells_.mass, direction);
    }

    const AreaFigures& figures() const { return figures_; }
    const Eigen::VectorXd& weights() const { return newton_.weights(); }

   private:
    /// Restores the triangulation after a trial that was not accepted.
    bool undo_step() {
        if (delaunay_.settled()) return true;
        delaunay_.step_back();
        return pass_.evaluate(euclidean_);
    }

    void measure() {
        const double tolerance = kTrialTolerance * area_tolerance(delaunay_.n_sites());
        const AreaFigures now = newton_.solve(areas_, tolerance, callback_);
        measure_cells(newton_.diagram(), newton_.heights(), workers_, cells_);
        figures_.largest_relative_error = now.largest_relative_error;
        figures_.converged = now.largest_relative_error <= area_tolerance(delaunay_.n_sites());
        figures_.newton_steps += now.newton_steps;
        figures_.products += now.products;
        figures_.trials += now.trials;
    }

    MovingDelaunay& delaunay_;
    const Eigen::VectorXd& areas_;
    const NewtonCallback& callback_;
    Workers& workers_;
    EnergyPass pass_;
    Energy euclidean_;
    AreaNewton newton_;
    PowerCells cells_;
    AreaFigures figures_;
};

Progress progress_of(int step, const Evaluation& here) {
    return {.iteration = step,
            .evaluations = step + 1,
            .value = here.value,
            .residual = here.residual,
            .rms_residual = here.rms_residual};
}

/// Moves each site to the centroid of its cell, a number of times.
RunStatistics run_centroidal_steps(AreaObjective& objective, int n_steps,
                                   const ProgressCallback& progress) {
    Eigen::VectorXf direction(objective.n_variables());
    Evaluation here;
    RunStatistics run{.stop = Stop::kStalled};
    for (int step = 0;; ++step) {
        if (!objective.evaluate(direction, step == 0 ? 0 : 1, here)) return run;
        objective.accept();
        run = {.stop = objective.figures().converged ? Stop::kConverged : Stop::kStalled,
               .iterations = step,
               .evaluations = step + 1,
               .energy = here.value,
               .residual = here.residual,
               .rms_residual = here.rms_residual};
        if (progress && !progress(progress_of(step, here))) {
            run.stop = Stop::kCancelled;
            return run;
        }
        if (step == n_steps) return run;
        objective.lloyd_step(here, direction);
    }
}

RunStatistics minimize(AreaObjective& objective, const MovingDelaunay& delaunay,
                       const AreaCvtOptions& options, const ProgressCallback& progress,
                       Workers& workers) {
    if (options.centroidal_steps >= 0) {
        return run_centroidal_steps(objective, options.centroidal_steps, progress);
    }
    OptimizerOptions optimizer{.tolerance = options.tolerance,
                               .max_move = kLargestMove * delaunay.spacing(),
                               .progress = progress};
    RunStatistics run = minimize_lbfgs(objective, optimizer, workers).run;
    if (run.stop == Stop::kConverged && !objective.figures().converged) run.stop = Stop::kStalled;
    return run;
}

/// Turns the released Delaunay triangulation into the regular one.
PeriodicDelaunay weighted(std::pair<Sites, TorusTriangulation> released, Eigen::VectorXd weights) {
    auto& [sites, triangulation] = released;
    const Lattice& reduced = sites.reduction().reduced;
    const double unit = gram_unit(reduced);
    const Eigen::VectorXd gram_weights = weights / (unit * unit);
    PowerFlips(triangulation, sites.coordinates(), gram_of(reduced), gram_weights).run();
    return {std::move(sites), std::move(triangulation), std::move(weights)};
}

}  // namespace

AreaCvtResult compute_area_cvt(const Lattice& lattice, const Points& points,
                               const AreaCvtOptions& options) {
    if (options.areas.size() != points.cols()) {
        throw InvalidInput("there are " + std::to_string(options.areas.size()) + " areas for " +
                           std::to_string(points.cols()) + " sites; give one for each site");
    }
    // Triangulate, and give the areas the order and the unit of the triangulation.
    MovingDelaunay delaunay(Sites(lattice, points), options.numbering);
    require_distinct(delaunay);
    const double unit = delaunay.unit();
    const int n = delaunay.n_sites();
    Eigen::VectorXd areas(n);
    for (SiteId s = 0; s < n; ++s) areas[s] = options.areas[delaunay.original_id(s)];
    areas *= delaunay.frame().ax * delaunay.frame().by / areas.sum();
    // Minimise.
    Workers workers(options.n_threads);
    AreaObjective objective(delaunay, areas, options.newton_progress, workers);
    const double value_unit = std::pow(unit, 4);
    ProgressCallback progress;
    if (options.progress) {
        progress = [&](Progress now) {
            now.value *= value_unit;
            return options.progress(now);
        };
    }
    RunStatistics run = minimize(objective, delaunay, options, progress, workers);
    run.energy *= value_unit;
    // Convert the result to the caller's order and units.
    Eigen::VectorXd weights(n);
    for (SiteId s = 0; s < n; ++s) {
        weights[delaunay.original_id(s)] = objective.weights()[s] * unit * unit;
    }
    const DelaunayCounts counts = delaunay.counts();
    return {.delaunay = weighted(delaunay.release(), std::move(weights)),
            .run = run,
            .areas = objective.figures(),
            .counts = counts};
}

}  // namespace pcvt
