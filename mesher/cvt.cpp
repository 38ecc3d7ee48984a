#include "mesher/cvt.hpp"

#include <cmath>

#include "mesher/energy.hpp"
#include "mesher/lbfgs.hpp"
#include "mesher/lloyd.hpp"
#include "mesher/voronoi.hpp"

namespace pcvt {
namespace {

/// In units of h. A site that moves further leaves its neighbourhood, and the model with it.
constexpr double kLargestMove = 0.5;

void evaluate(const PeriodicDelaunay& delaunay, Evaluation& evaluation) {
    const Energy state = energy(delaunay);
    const Points step =
        -(state.gradient.array().rowwise() / (2 * state.mass.transpose().array())).matrix();
    const auto squares = (step / delaunay.sites().spacing()).colwise().squaredNorm();
    evaluation.value = state.value;
    evaluation.gradient = state.gradient.reshaped();
    evaluation.lloyd_step = step.reshaped();
    evaluation.residual = std::sqrt(squares.maxCoeff());
    evaluation.rms_residual = std::sqrt(squares.mean());
}

}  // namespace

CvtResult compute_cvt(const Lattice& lattice, const Points& points, const CvtOptions& options) {
    CvtResult result{PeriodicDelaunay(Sites(lattice, points)), Stop::kStalled, 0, 0, 0, 0, 0, 0};
    PeriodicDelaunay& delaunay = result.delaunay;
    const Objective objective = [&](const Eigen::VectorXd& x, Evaluation& evaluation) {
        if (!delaunay.move_to(x.reshaped(2, x.size() / 2))) return false;
        evaluate(delaunay, evaluation);
        return true;
    };
    const OptimizerOptions optimizer{options.tolerance, options.max_iterations,
                                     kLargestMove * delaunay.sites().spacing(), options.progress};
    const auto minimize = options.solver == Solver::kLloyd ? minimize_lloyd : minimize_lbfgs;
    const OptimizerResult run = minimize(objective, points.reshaped(), optimizer);

    // The last trial need not be the step that was taken.
    delaunay.move_to(run.x.reshaped(2, points.cols()));
    delaunay.certify();
    result.stop = run.stop;
    result.iterations = run.iterations;
    result.evaluations = run.evaluations;
    result.energy = run.evaluation.value;
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
