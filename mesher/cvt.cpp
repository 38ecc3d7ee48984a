#include "mesher/cvt.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/energy.hpp"
#include "mesher/error.hpp"
#include "mesher/lbfgs.hpp"
#include "mesher/lloyd.hpp"
#include "mesher/voronoi.hpp"

namespace pcvt {
namespace {

/// In units of h. A site that moves further leaves its neighbourhood, and the model with it.
constexpr double kLargestMove = 0.5;

/// The nearest neighbours of all sites are joined by Delaunay edges, so no pair is overlooked.
void require_distinct(const PeriodicDelaunay& delaunay) {
    const Sites& sites = delaunay.sites();
    const TorusTriangulation& t = delaunay.triangulation();
    std::pair<SiteId, SiteId> found{-1, -1};
    for (int h = 0; h < t.n_halfedges(); ++h) {
        const Corner& from = t.corner(h);
        const Corner& to = t.corner(TorusTriangulation::next(h));
        const Vec2 edge = sites.reduction().reduced.to_plane(
            difference(image(sites, from.site, from.offset), image(sites, to.site, to.offset)));
        if (edge.norm() >= kSameVertex * sites.spacing()) continue;
        const std::pair<SiteId, SiteId> pair = std::minmax({from.site, to.site});
        if (found.first < 0 || pair < found) found = pair;
    }
    if (found.first >= 0) throw DuplicateSites(found.first, found.second);
}

/// A power of two near h. The optimiser works in this unit, exactly, so that neither its products
/// nor its thresholds depend on the user's unit of length.
double unit_of(const Sites& sites) {
    int exponent = 0;
    std::frexp(sites.spacing(), &exponent);
    return std::ldexp(1.0, exponent);
}

/// The state of `delaunay` with lengths in `unit`.
void evaluate(const PeriodicDelaunay& delaunay, double unit, Evaluation& evaluation) {
    const Energy state = energy(delaunay);
    const Points step =
        -(state.gradient.array().rowwise() / (2 * state.mass.transpose().array())).matrix();
    const auto squares = (step / delaunay.sites().spacing()).colwise().squaredNorm();
    evaluation.value = state.value / std::pow(unit, 4);
    evaluation.gradient = state.gradient.reshaped() / std::pow(unit, 3);
    evaluation.lloyd_step = step.reshaped() / unit;
    evaluation.residual = std::sqrt(squares.maxCoeff());
    evaluation.rms_residual = std::sqrt(squares.mean());
}

}  // namespace

CvtResult compute_cvt(const Lattice& lattice, const Points& points, const CvtOptions& options) {
    CvtResult result{PeriodicDelaunay(Sites(lattice, points)), Stop::kStalled, 0, 0, 0, 0, 0, 0};
    PeriodicDelaunay& delaunay = result.delaunay;
    require_distinct(delaunay);
    const double unit = unit_of(delaunay.sites());
    const auto points_at = [unit](const Eigen::VectorXd& x) -> Points {
        return unit * x.reshaped(2, x.size() / 2);
    };
    const Objective objective = [&](const Eigen::VectorXd& x, Evaluation& evaluation) {
        if (!delaunay.move_to(points_at(x))) return false;
        evaluate(delaunay, unit, evaluation);
        return true;
    };
    OptimizerOptions optimizer{options.tolerance,
                               options.max_iterations,
                               kLargestMove * delaunay.sites().spacing() / unit,
                               {}};
    if (options.progress) {
        optimizer.progress = [&](Progress progress) {
            progress.value *= std::pow(unit, 4);
            return options.progress(progress);
        };
    }
    const auto minimize = options.solver == Solver::kLloyd ? minimize_lloyd : minimize_lbfgs;
    const OptimizerResult run = minimize(objective, points.reshaped() / unit, optimizer);

    // The last trial need not be the step that was taken.
    delaunay.move_to(points_at(run.x));
    delaunay.certify();
    result.stop = run.stop;
    result.iterations = run.iterations;
    result.evaluations = run.evaluations;
    result.energy = run.evaluation.value * std::pow(unit, 4);
    result.energy_bound = hexagonal_bound(lattice.area(), delaunay.sites().n_sites());
    result.residual = run.evaluation.residual;
    result.rms_residual = run.evaluation.rms_residual;
    return result;
}

PeriodicMesh periodic_mesh(const CvtResult& result, TileKind kind) {
    return kind == TileKind::kCells ? cell_mesh(result.delaunay) : triangle_mesh(result.delaunay);
}

double hexagonal_bound(double area, int n_sites) {
    return 5 * area * area / (18 * std::sqrt(3.0) * n_sites);
}

}  // namespace pcvt
