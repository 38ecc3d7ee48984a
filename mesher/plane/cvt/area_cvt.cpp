#include "mesher/plane/cvt/area_cvt.hpp"

#include <cmath>
#include <optional>

#include "mesher/base/error.hpp"
#include "mesher/cvt/residuals.hpp"
#include "mesher/optimize/lbfgs.hpp"
#include "mesher/plane/energy/energy.hpp"
#include "mesher/plane/power/power_diagram.hpp"
#include "mesher/plane/symmetry/symmetric_objective.hpp"

namespace pcvt::plane {
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
    AreaObjective(MovingDelaunay& delaunay, const Eigen::VectorXd& areas, WeightOrbits orbits,
                  const NewtonCallback& callback, Workers& workers)
        : delaunay_(delaunay),
          areas_(areas),
          callback_(callback),
          workers_(workers),
          pass_(delaunay, workers),
          newton_(delaunay, workers, std::move(orbits)) {}

    Eigen::Index n_variables() const override { return 2 * Eigen::Index{delaunay_.n_sites()}; }

    bool evaluate(const Eigen::VectorXf& direction, double t, Evaluation& evaluation) override {
        if (!undo_step()) return false;
        if (t != 0 && !delaunay_.step(direction, t, workers_)) return false;
        if (!pass_.evaluate(euclidean_)) return false;
        measure();
        const auto [largest, rms] =
            residuals(cells_.gradient, cells_.mass, delaunay_.spacing(), workers_);
        // g(w): its error is quadratic in that of the areas, that of the energy is linear.
        evaluation.value = cells_.value + newton_.weights().dot(areas_ - cells_.mass);
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

    const SizeFigures& figures() const { return figures_; }
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
        const SizeFigures now = newton_.solve(areas_, tolerance, callback_);
        measure_cells(newton_.diagram().regular(), newton_.diagram().heights(), workers_, cells_);
        figures_.largest_relative_error = now.largest_relative_error;
        figures_.rounding = now.rounding;
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
    Energy cells_;
    SizeFigures figures_;
};

Progress progress_of(int step, const Evaluation& here) {
    return {.iteration = step,
            .evaluations = step + 1,
            .value = here.value,
            .residual = here.residual,
            .rms_residual = here.rms_residual};
}

/// Why a limited number of steps ended.
Stop stop_after_steps(const Evaluation& here, const SizeFigures& figures, double tolerance) {
    if (!figures.converged) return Stop::kStalled;
    return here.residual <= tolerance ? Stop::kConverged : Stop::kIterationLimit;
}

/// Moves each site to the centroid of its cell, a number of times.
/// @param figures  of the objective's last evaluation.
RunStatistics run_centroidal_steps(Objective& objective, const SizeFigures& figures,
                                   const AreaCvtOptions& options,
                                   const ProgressCallback& progress) {
    Eigen::VectorXf direction(objective.n_variables());
    Evaluation here;
    RunStatistics run{.stop = Stop::kStalled};
    for (int step = 0;; ++step) {
        if (!objective.evaluate(direction, step == 0 ? 0 : 1, here)) return run;
        objective.accept();
        run = {.stop = stop_after_steps(here, figures, options.run.tolerance),
               .iterations = step,
               .evaluations = step + 1,
               .energy = here.value,
               .residual = here.residual,
               .rms_residual = here.rms_residual};
        if (progress && !progress(progress_of(step, here))) {
            run.stop = Stop::kCancelled;
            return run;
        }
        if (step == options.run.max_iterations) return run;
        objective.lloyd_step(here, direction);
    }
}

/// @param orbits  nullptr: no site is tied to another one.
RunStatistics minimize(AreaObjective& all, const OrbitEmbedding* orbits, double spacing,
                       const AreaCvtOptions& options, const ProgressCallback& progress,
                       Workers& workers) {
    std::optional<SymmetricObjective> symmetric;
    if (orbits != nullptr) symmetric.emplace(all, *orbits);
    Objective& objective = symmetric ? static_cast<Objective&>(*symmetric) : all;
    if (options.run.max_iterations >= 0) {
        return run_centroidal_steps(objective, all.figures(), options, progress);
    }
    OptimizerOptions optimizer{.tolerance = options.run.tolerance,
                               .max_move = kLargestMove * spacing,
                               .progress = progress};
    RunStatistics run = minimize_lbfgs(objective, optimizer, workers).run;
    if (run.stop == Stop::kConverged && !all.figures().converged) run.stop = Stop::kStalled;
    return run;
}

/// A symmetry of sites, in the order of their triangulation.
struct TiedSites {
    OrbitEmbedding moves;
    WeightOrbits weights;
};

/// @param tied  nullptr: none.
AreaCvtResult minimized(MovingDelaunay delaunay, const TiedSites* tied,
                        const AreaCvtOptions& options) {
    require_distinct(delaunay);
    // Give the areas the order and the unit of the triangulation.
    const double unit = delaunay.unit();
    const int n = delaunay.n_sites();
    Eigen::VectorXd areas(n);
    for (SiteId s = 0; s < n; ++s) areas[s] = options.areas[delaunay.original_id(s)];
    areas *= delaunay.frame().ax * delaunay.frame().by / areas.sum();
    // Minimise.
    Workers workers(options.run.n_threads);
    AreaObjective objective(delaunay, areas, tied ? tied->weights : WeightOrbits(),
                            options.newton_progress, workers);
    const double value_unit = std::pow(unit, 4);
    const std::function<Points()> positions = [&delaunay] { return delaunay.positions(); };
    ProgressCallback progress;
    if (options.run.progress) {
        progress = [&](Progress now) {
            now.value *= value_unit;
            now.positions = &positions;
            return options.run.progress(now);
        };
    }
    RunStatistics run = minimize(objective, tied ? &tied->moves : nullptr, delaunay.spacing(),
                                 options, progress, workers);
    run.energy *= value_unit;
    // Convert the result to the caller's order and units.
    Eigen::VectorXd weights(n);
    for (SiteId s = 0; s < n; ++s) {
        weights[delaunay.original_id(s)] = objective.weights()[s] * unit * unit;
    }
    const DelaunayCounts counts = delaunay.counts();
    return {.delaunay = weighted_delaunay(delaunay.release(), std::move(weights)),
            .run = run,
            .areas = objective.figures(),
            .counts = counts};
}

}  // namespace

void require_areas(const AreaCvtOptions& options, int n_sites) {
    if (options.areas.size() == n_sites) return;
    throw InvalidInput("there are " + std::to_string(options.areas.size()) + " areas for " +
                       std::to_string(n_sites) + " sites; give one for each site");
}

AreaCvtResult compute_area_cvt(const Lattice& lattice, const Points& points,
                               const AreaCvtOptions& options) {
    require_areas(options, static_cast<int>(points.cols()));
    return minimized(MovingDelaunay(Sites(lattice, points), options.numbering), nullptr, options);
}

AreaCvtResult compute_area_cvt(const SymmetricSites& start, const AreaCvtOptions& options) {
    require_areas(options, start.sites.n_sites());
    MovingDelaunay delaunay(start.sites);
    TiedSites tied{tie_orbits(start, delaunay), {}};
    std::vector<int> orbit;
    for (SiteId s = 0; s < delaunay.n_sites(); ++s) {
        orbit.push_back(start.orbit[delaunay.original_id(s)]);
    }
    tied.weights = WeightOrbits(std::move(orbit));
    return minimized(std::move(delaunay), &tied, options);
}

}  // namespace pcvt::plane
