#include "mesher/space/cvt/volume_cvt.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "mesher/base/error.hpp"
#include "mesher/cvt/residuals.hpp"
#include "mesher/space/cvt/distinct_sites.hpp"
#include "mesher/space/cvt/volume_newton.hpp"
#include "mesher/space/energy/energy_pass.hpp"

namespace pcvt::space {
namespace {

/// A centroidal step over the way to the centroid. With 1 it takes more steps to as round cells;
/// with 2 sites no longer settle.
constexpr float kBold = 1.5F;
/// The tolerance of volumes where sites will move on: that of one cell affects the centroids
/// little. The energy after five steps is the same to 1e-6 as with a tolerance of 1e-4. Long runs,
/// and those that end at a residual, need better volumes in the end.
constexpr double kLoosePassing = 0.1;
constexpr double kTightPassing = 1e-4;
constexpr int kLooseSteps = 5;

double passing_tolerance(int step, int limit) {
    if (limit < 0) return kTightPassing;
    return std::max(kTightPassing, std::ldexp(kLoosePassing, std::min(0, kLooseSteps - step)));
}

/// The largest difference between the sum of the volumes and the domain, relative.
constexpr double kSumTolerance = 1e-6;

/// The sites in the order of values, equal ones by number.
std::vector<SiteId> ranked(const Eigen::VectorXd& values) {
    std::vector<SiteId> order(static_cast<std::size_t>(values.size()));
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](SiteId s, SiteId t) { return values[s] < values[t]; });
    return order;
}

Eigen::VectorXd by_rank(const Eigen::VectorXd& volumes, const Eigen::VectorXd& cells) {
    const std::vector<SiteId> of_cells = ranked(cells);
    const std::vector<SiteId> of_volumes = ranked(volumes);
    Eigen::VectorXd given(volumes.size());
    for (std::size_t k = 0; k < of_cells.size(); ++k) given[of_cells[k]] = volumes[of_volumes[k]];
    return given;
}

/// A run in the frame, the unit and the order of the moving tetrahedra.
class VolumeRun {
   public:
    VolumeRun(MovingTetrahedra& moving, const VolumeCvtOptions& options, Workers& workers)
        : moving_(moving),
          options_(options),
          workers_(workers),
          pass_(moving, workers),
          newton_(moving, workers) {}

    /// Steps until the limit or the tolerance.
    /// @param targets  by site of the caller.
    RunStatistics run(const Eigen::VectorXd& targets);

    /// The volumes of the cells of the Delaunay tetrahedra, by site of the caller.
    Eigen::VectorXd voronoi_volumes() const {
        PowerDiagram diagram(moving_, workers_);
        diagram.start();
        diagram.set_weights(Eigen::VectorXd::Zero(moving_.n_sites()));
        return original_order(diagram.sizes());
    }
    Eigen::VectorXd cell_volumes() const {
        return original_order(newton_.sizes()) * std::pow(moving_.unit(), 3);
    }
    const SizeFigures& figures() const { return figures_; }
    double largest_error() const { return largest_error_; }
    double rounding() const { return rounding_; }
    const PowerDiagram& diagram() const { return newton_.diagram(); }

   private:
    Eigen::VectorXd original_order(const Eigen::VectorXd& values) const {
        Eigen::VectorXd ordered(values.size());
        for (SiteId s = 0; s < moving_.n_sites(); ++s) {
            ordered[moving_.original_id(s)] = values[s];
        }
        return ordered;
    }
    SizeFigures solve(const Eigen::VectorXd& targets, double tolerance);
    RunStatistics measure(const Eigen::VectorXd& targets, int step, double tolerance);
    bool report(const RunStatistics& now) const;
    bool move();

    MovingTetrahedra& moving_;
    const VolumeCvtOptions& options_;
    Workers& workers_;
    EnergyPass pass_;
    Energy euclidean_;
    VolumeNewton newton_;
    Energy cells_;
    SizeFigures figures_;
    double largest_error_ = 0;
    double rounding_ = 0;
};

/// Finds the weights at the present position.
SizeFigures VolumeRun::solve(const Eigen::VectorXd& targets, double tolerance) {
    const SizeFigures now = newton_.solve(targets, tolerance, options_.newton_progress);
    figures_.newton_steps += now.newton_steps;
    figures_.products += now.products;
    figures_.trials += now.trials;
    largest_error_ = (newton_.sizes() - targets).cwiseAbs().maxCoeff() / targets.mean();
    return now;
}

/// Finds the weights at the present position, and the figures of the cells.
RunStatistics VolumeRun::measure(const Eigen::VectorXd& targets, int step, double tolerance) {
    SizeFigures now = solve(targets, tolerance);
    // Cells larger than the mean need a smaller relative error.
    const bool is_last = tolerance < kTightPassing;
    if (is_last && now.largest_relative_error <= tolerance && largest_error_ > tolerance) {
        now = solve(targets, tolerance * targets.mean() / targets.maxCoeff());
    }
    figures_.largest_relative_error = now.largest_relative_error;
    figures_.rounding = now.rounding;
    rounding_ = largest_error_ <= tolerance ? 0 : newton_.rounding() / targets.mean();
    figures_.converged = now.converged || largest_error_ <= std::max(tolerance, rounding_);
    measure_cells(newton_.diagram().regular(), workers_, cells_);
    const auto [largest, rms] =
        residuals(cells_.gradient, cells_.mass, moving_.spacing(), workers_);
    const bool at_rest = largest <= options_.run.tolerance;
    return {.stop = !figures_.converged ? Stop::kStalled
                                        : (at_rest ? Stop::kConverged : Stop::kIterationLimit),
            .iterations = step,
            .evaluations = step + 1,
            .energy = cells_.value * std::pow(moving_.unit(), 5),
            .residual = largest,
            .rms_residual = rms};
}

bool VolumeRun::report(const RunStatistics& now) const {
    if (!options_.run.progress) return true;
    return options_.run.progress({.iteration = now.iterations,
                                  .evaluations = now.evaluations,
                                  .value = now.energy,
                                  .residual = now.residual,
                                  .rms_residual = now.rms_residual});
}

/// Takes a bold step, and restores the Delaunay tetrahedra.
/// @returns false if sites coincide then; they have not moved.
bool VolumeRun::move() {
    Eigen::VectorXf direction;
    steps_to_centroids(cells_.gradient, cells_.mass, direction);
    direction *= kBold;
    if (!moving_.step(direction, 1, workers_)) return false;
    if (pass_.evaluate(euclidean_)) {
        moving_.settle();
        return true;
    }
    moving_.step_back();
    pass_.evaluate(euclidean_);
    return false;
}

RunStatistics VolumeRun::run(const Eigen::VectorXd& targets) {
    // Give the targets the order and the unit of the tetrahedra.
    Eigen::VectorXd ordered(targets.size());
    for (SiteId s = 0; s < moving_.n_sites(); ++s) ordered[s] = targets[moving_.original_id(s)];
    ordered *= moving_.frame().volume() / ordered.sum();
    const double tolerance = volume_tolerance(moving_.n_sites());
    const int limit = options_.run.max_iterations;
    for (int step = 0;; ++step) {
        const bool is_last = step == limit;
        RunStatistics now =
            measure(ordered, step, is_last ? tolerance : passing_tolerance(step, limit));
        const bool cancelled = !report(now);
        const bool at_rest = limit < 0 && now.stop == Stop::kConverged;
        if (!is_last && !cancelled && !at_rest && move()) continue;
        if (!is_last) {
            now = measure(ordered, step, tolerance);
            if (!cancelled && !at_rest) now.stop = Stop::kStalled;
        }
        if (cancelled) now.stop = Stop::kCancelled;
        return now;
    }
}

}  // namespace

void require_volumes(const Eigen::VectorXd& volumes, const Lattice& lattice, Eigen::Index n_sites) {
    if (volumes.size() != n_sites) {
        throw InvalidInput("there are " + std::to_string(volumes.size()) + " volumes for " +
                           std::to_string(n_sites) + " sites; give one for each site");
    }
    for (Eigen::Index s = 0; s < volumes.size(); ++s) {
        if (volumes[s] > 0 && std::isfinite(volumes[s])) continue;
        throw InvalidInput("the volume of site " + std::to_string(s) +
                           " is not a positive finite number; correct it");
    }
    if (!(std::abs(volumes.sum() / lattice.volume() - 1) <= kSumTolerance)) {
        throw InvalidInput(
            "the volumes do not sum to the volume of the domain; scale them to this sum");
    }
}

VolumeCvtResult compute_volume_cvt(const Lattice& lattice, const Points& points,
                                   const VolumeCvtOptions& options) {
    require_volumes(options.volumes, lattice, points.cols());
    MovingTetrahedra moving(distinct_sites(lattice, points));
    Workers workers(options.run.n_threads);
    VolumeRun run(moving, options, workers);
    Eigen::VectorXd targets =
        options.by_rank ? by_rank(options.volumes, run.voronoi_volumes()) : options.volumes;
    const RunStatistics statistics = run.run(targets);
    Eigen::VectorXd cell_volumes = run.cell_volumes();
    const int n_rebuilds = moving.n_rebuilds();
    return {.delaunay = weighted_delaunay(moving, run.diagram()),
            .targets = std::move(targets),
            .cell_volumes = std::move(cell_volumes),
            .run = statistics,
            .volumes = run.figures(),
            .largest_error = run.largest_error(),
            .rounding = run.rounding(),
            .counts = run.diagram().counts(),
            .n_rebuilds = n_rebuilds};
}

}  // namespace pcvt::space
