#include "mesher/plane/areas/area_newton.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesher/cells/laplacian_solver.hpp"
#include "mesher/plane/power/power_flips.hpp"

namespace pcvt::plane {
namespace {

/// The linear equations are solved to this relative residual at first. Near the solution they are
/// solved to a multiple of the error, so that convergence stays quadratic, or so far that the error
/// of the least area meets the tolerance, which suffices for the last step.
constexpr double kLoosest = 1e-2;
constexpr double kPerError = 0.3;
constexpr double kPerTolerance = 0.1;
constexpr double kTightest = 1e-8;
/// Where only steps below this are acceptable along an approximate solution, its error exceeds the
/// areas of small cells, and it is solved again to a fraction of the residual.
constexpr double kShortForApproximate = 0x1p-6;
constexpr double kTighter = 1e-3;
/// Weights of an earlier call are of use if every cell has at least this share of its least target.
constexpr double kSmallestWarmCell = 0.1;
/// The first trial is this many times as long as the last step, at most the full one.
constexpr double kLonger = 4;
/// A step shorter than this makes no progress.
constexpr double kShortestStep = 0x1p-30;
/// Errors below this, relative to the areas, may be rounding: steps are judged by the largest
/// relative error, and a full step that does not halve it ends the iteration.
constexpr double kRounding = 1e-9;
constexpr int kMostSteps = 200;
/// The roundings of weights, and of the heights that follow from them, that add up in one area.
constexpr double kWeightRoundings = 64;

double largest_error(const Eigen::VectorXd& mass, const Eigen::VectorXd& areas) {
    return ((mass - areas).array().abs() / areas.array()).maxCoeff();
}

}  // namespace

AreaNewton::AreaNewton(const MovingDelaunay& delaunay, Workers& workers, WeightOrbits orbits)
    : delaunay_(delaunay), workers_(workers), orbits_(std::move(orbits)) {}

/// Makes the triangulation regular for the weights, and measures the cells; returns false if a site
/// is hidden.
bool AreaNewton::restore(State& state) const {
    const double to_gram = delaunay_.unit() / delaunay_.gram_unit();
    const Eigen::VectorXd gram_weights = state.weights * (to_gram * to_gram);
    if (!gram_weights.allFinite()) return false;
    PowerFlips flips(state.regular, delaunay_.coordinates(), delaunay_.gram(), gram_weights);
    if (flips.run()) return false;
    measure_masses(diagram(state), workers_, state.heights, state.mass);
    return true;
}

CellGraph AreaNewton::graph() const {
    CellGraph cells;
    assemble_cell_graph(diagram(here_), here_.heights, workers_, cells);
    return orbits_.merged(std::move(cells));
}

/// Chooses the weights at which the iteration begins.
void AreaNewton::begin(double least_area) {
    here_.regular = delaunay_.triangulation();
    if (here_.weights.size() == delaunay_.n_sites()) {
        if (restore(here_) && here_.mass.minCoeff() >= kSmallestWarmCell * least_area) return;
        here_.regular = delaunay_.triangulation();
    }
    here_.weights.setZero(delaunay_.n_sites());
    restore(here_);
}

/// Halves the step along `direction` until it is acceptable, or shorter than `shortest`.
AreaNewton::Outcome AreaNewton::search(const Eigen::VectorXd& areas,
                                       const Eigen::VectorXd& direction, double shortest,
                                       double least_mass, AreaFigures& figures) {
    const double size = (areas - here_.mass).norm();
    const bool near = size < kRounding * areas.norm();
    for (double t = std::min(1.0, kLonger * last_step_); t >= shortest; t /= 2) {
        trial_.regular = here_.regular;
        trial_.weights = here_.weights + t * direction;
        trial_.weights.array() -= trial_.weights.mean();
        ++figures.trials;
        if (!restore(trial_) || !(trial_.mass.minCoeff() >= least_mass)) continue;
        const bool lower =
            near ? largest_error(trial_.mass, areas) <= largest_error(here_.mass, areas) / 2
                 : (areas - trial_.mass).norm() <= (1 - t / 2) * size;
        if (lower) {
            std::swap(here_, trial_);
            last_step_ = t;
            return Outcome::kAccepted;
        }
        if (near) return Outcome::kRounding;
    }
    return Outcome::kTooShort;
}

/// Takes one damped step; returns false if no step lowers the error.
bool AreaNewton::step(const Eigen::VectorXd& areas, double tolerance, double least_mass,
                      AreaFigures& figures) {
    const Eigen::VectorXd error = areas - here_.mass;
    const Eigen::VectorXd error_of_orbits = orbits_.sums(error);
    LaplacianSolver solver(graph());
    Eigen::VectorXd direction;
    const double least_error = tolerance * areas.minCoeff() * std::sqrt(double(areas.size()));
    double accuracy = std::max(kPerError * error.norm() / areas.norm(),
                               kPerTolerance * least_error / error.norm());
    for (accuracy = std::min(accuracy, kLoosest);; accuracy *= kTighter) {
        const bool tightest = accuracy <= kTightest;
        figures.products += solver.solve(error_of_orbits, std::max(accuracy, kTightest), direction);
        const double shortest = tightest ? kShortestStep : kShortForApproximate;
        const Outcome outcome =
            search(areas, orbits_.spread(direction), shortest, least_mass, figures);
        if (outcome == Outcome::kAccepted) return true;
        if (outcome == Outcome::kRounding || tightest) return false;
    }
}

/// See AreaFigures::rounding.
double AreaNewton::rounding(const Eigen::VectorXd& areas) const {
    const CellGraph cells = graph();
    double largest = 0;
    for (int s = 0; s < cells.n_rows(); ++s) {
        double sum = 0;
        for (int k = cells.row_begin[s]; k < cells.row_begin[s + 1]; ++k) {
            sum += cells.conductance[k];
        }
        largest = std::max(largest, sum);
    }
    return kWeightRoundings * kUnitRoundoff * here_.weights.cwiseAbs().maxCoeff() * largest /
           orbits_.sums(areas).minCoeff();
}

AreaFigures AreaNewton::solve(const Eigen::VectorXd& areas, double tolerance,
                              const NewtonCallback& callback) {
    begin(areas.minCoeff());
    last_step_ = 1;
    const double least_mass = std::min(areas.minCoeff(), here_.mass.minCoeff()) / 2;
    AreaFigures figures;
    for (;;) {
        figures.largest_relative_error = largest_error(here_.mass, areas);
        figures.converged = figures.largest_relative_error <= tolerance;
        if (callback) callback(figures);
        if (figures.converged) return figures;
        if (figures.newton_steps == kMostSteps) break;
        if (!step(areas, tolerance, least_mass, figures)) break;
        ++figures.newton_steps;
    }
    figures.rounding = rounding(areas);
    figures.converged = figures.largest_relative_error <= figures.rounding;
    return figures;
}

}  // namespace pcvt::plane
