#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "mesher/base/error.hpp"
#include "mesher/cvt/centroid_figures.hpp"
#include "mesher/cvt/centroid_patience.hpp"
#include "mesher/cvt/cvt_objective.hpp"
#include "mesher/cvt/size_newton.hpp"
#include "mesher/optimize/conjugate_gradients.hpp"
#include "mesher/optimize/convex_lbfgs.hpp"

namespace pcvt {

/// Prescribed centroids and sites that are fitted to them stay this far from each other, in units
/// of h: cells of sites whose coordinates are rounded, by 2^-50 of a period, are still exact to
/// 1e-9 of the mean size then.
inline constexpr double kNearestSites = 1e-5;

/// Finds the sites whose power cells have prescribed sizes s_i and centroids t_i, in the plane and
/// in space.
///
/// Let E(x) be the energy of the cells of sites x with these sizes, the maximum over the weights of
/// g (size_newton.hpp), and g_i the centroid of cell i. Then
///
///   P(x)      =  sum over i of s_i |x_i - t_i|^2  -  E(x)
///   dP/dx_i   =  2 s_i (g_i - t_i)
///
/// is convex: without the squares of the sites and of the points, which cancel, it is a maximum of
/// linear functions, one for each way to transport the domain to the sites (D. Bourne, M. Pearce,
/// S. Roper 2024). Its minimum has the prescribed centroids. x_i and t_i are compared unwrapped,
/// and E is bounded on the torus, so that a minimum exists for any centroids. Where it lies at
/// sites that coincide, which centroids of no power diagram may bring about, sites come close to
/// each other, but stay so far apart that doubles and files hold their cells: a step that brings
/// two sites within kNearestSites is shortened. The run ends as stalled once the centroids no
/// longer come nearer.
///
/// L-BFGS minimises P from x = t. In units of 2 s_i its Hessian is near to the identity, so that
/// the first step is t_i - g_i. Sites of cells that are far from round lie near each other, where
/// the Hessian grows as the inverse of their distance and L-BFGS needs many iterations. With
/// `derivatives`, Newton's steps follow once the centroids are near: 300 relaxed cells in the plane
/// are found after 9 iterations instead of 146, cells of random sites after some 500 instead of
/// 1,500.
///
/// `Pass` evaluates a moving triangulation `Pass::Moving` as in CvtObjective, and `Diagram` is its
/// power diagram as in SizeNewton.
template <class Pass, class Diagram>
class CentroidObjective final : public Objective {
   public:
    using Moving = typename Pass::Moving;
    using Points = std::decay_t<decltype(std::declval<Moving>().coordinates())>;
    using Point = Eigen::Vector<double, Moving::kDimension>;
    using Measure = void(const Diagram& diagram, Workers& workers, Energy& cells);
    /// The length of the shortest edge between two sites, units.
    using ShortestEdge = double(const Moving& moving);
    /// Assembles plane::assemble_moment_derivatives.
    using Derivatives = void(const Diagram& diagram, double unit, BlockMatrix& matrix);

    /// All arguments but the functions must outlive this object.
    /// @param moving  its sites are the prescribed centroids.
    /// @param sizes   s_i in the unit and the order of `moving`, with the sum of the domain's size.
    CentroidObjective(Moving& moving, const Eigen::VectorXd& sizes, Workers& workers,
                      const NewtonCallback& callback, Measure* measure, ShortestEdge* shortest_edge,
                      Derivatives* derivatives = nullptr)
        : moving_(moving),
          sizes_(sizes),
          workers_(workers),
          callback_(callback),
          measure_(measure),
          shortest_edge_(shortest_edge),
          derivatives_(derivatives),
          pass_(moving, workers),
          newton_(moving, workers),
          targets_(moving.coordinates()),
          from_targets_(Points::Zero(Moving::kDimension, moving.n_sites())),
          trial_(from_targets_) {}

    Eigen::Index n_variables() const override { return kNumbers * Eigen::Index{moving_.n_sites()}; }

    bool evaluate(const Eigen::VectorXf& direction, double t, Evaluation& evaluation) override {
        if (!undo_step()) return false;
        if (t != 0 && !moving_.step(direction, t, workers_)) return false;
        if (!pass_.evaluate(euclidean_)) return false;
        if (t != 0 && shortest_edge_(moving_) < kNearestSites * moving_.spacing()) return false;
        place(direction, t);
        if (!solve(kTrialTolerance)) return false;
        fill(evaluation);
        if (t == 0) note_best();
        return true;
    }

    void accept() override {
        moving_.settle();
        from_targets_ = trial_;
        note_best();
    }
    void reject() override { undo_step(); }
    void lloyd_step(const Evaluation& evaluation, Eigen::VectorXf& direction) const override {
        direction = -scaled(evaluation.gradient).template cast<float>();
    }

    /// Newton's step at the point, which must have been evaluated last, in sites and weights at
    /// once: to first order, the sizes stay and the centroids become those prescribed.
    /// @returns false if there is none: `derivatives` is null, or the step does not lead down.
    bool newton_step(const Evaluation& here, double radius, Eigen::VectorXf& direction) {
        if (derivatives_ == nullptr || here.rms_residual > kNewtonBelow || !undo_step())
            return false;
        BlockMatrix matrix;
        (*derivatives_)(newton_.diagram(), moving_.spacing(), matrix);
        // A site has kNumbers numbers, then two for its weight.
        const int n = moving_.n_sites();
        constexpr int kAll = kNumbers + 2;
        Eigen::VectorXd slope = Eigen::VectorXd::Zero(Eigen::Index{kAll} * n);
        for (int s = 0; s < n; ++s) {
            slope.segment<kNumbers>(kAll * s) = here.gradient.segment<kNumbers>(kNumbers * s) / 2;
        }
        ConjugateGradients solver(slope.size(), workers_);
        solver.solve(matrix, slope,
                     {.relative_residual = std::clamp(here.rms_residual, kExactStep, kLooseStep),
                      .radius = radius,
                      .products = kMostProducts});
        direction.resize(n_variables());
        for (int s = 0; s < n; ++s) {
            direction.segment<kNumbers>(kNumbers * s) =
                solver.solution().segment<kNumbers>(kAll * s).template cast<float>();
        }
        return direction.allFinite() && direction.cast<double>().dot(here.gradient) < 0;
    }

    /// Goes to the point of the run with the nearest centroids, which need not be the last one, and
    /// solves for the sizes there, to a tolerance of their mean.
    /// @returns the figures of the centroids.
    /// @throws InvalidInput if the sizes are not reached.
    CentroidFigures finish(double tolerance) {
        undo_step();
        const Eigen::VectorXf back = step_to_best();
        if (moving_.step(back, 1, workers_) && pass_.evaluate(euclidean_)) {
            place(back, 1);
            moving_.settle();
            newton_.start_next_from(best_weights_);
        } else {
            undo_step();
            pass_.evaluate(euclidean_);
            trial_ = from_targets_;
        }
        if (!solve(tolerance)) {
            throw InvalidInput(
                "doubles do not hold power cells with these sizes and centroids; correct the "
                "centroids and the sizes, or take fewer iterations");
        }
        Evaluation last;
        fill(last);
        const Eigen::VectorXd apart = scaled(last.gradient);
        CentroidFigures figures;
        for (int s = 0; s < moving_.n_sites(); ++s) {
            const double off = apart.segment<kNumbers>(kNumbers * s).norm() / moving_.spacing();
            figures.largest = std::max(figures.largest, off);
            figures.mean += off / moving_.n_sites();
        }
        return figures;
    }
    /// newton_steps, products and trials count the whole run.
    const SizeFigures& figures() const { return figures_; }
    /// max |m_i - s_i| over the mean size.
    double largest_error() const {
        return (newton_.sizes() - sizes_).cwiseAbs().maxCoeff() / sizes_.mean();
    }
    const SizeNewton<Diagram>& newton() const { return newton_; }
    const Energy& cells() const { return cells_; }

   private:
    static constexpr int kNumbers = Moving::kNumbersPerSite;
    /// Of sizes at positions that sites will leave; the value's error is its square.
    static constexpr double kTrialTolerance = 1e-8;
    /// A part of the mean size; steps to sites whose sizes are off by more are shortened.
    static constexpr double kWorstTrial = 1e-5;
    /// The linear equations of a step are solved to the RMS residual, within these limits.
    static constexpr double kExactStep = 1e-4;
    static constexpr double kLooseStep = 1e-2;
    static constexpr int kMostProducts = 2000;
    /// Farther away the quadratic model does not hold.
    static constexpr double kNewtonBelow = 1e-2;

    bool undo_step() {
        if (moving_.settled()) return true;
        moving_.step_back();
        return Moving::kStepsUnrestored || pass_.evaluate(euclidean_);
    }

    /// Notes the point if its centroids are the nearest ones.
    void note_best() {
        if (!(rms_ < best_rms_)) return;
        best_rms_ = rms_;
        best_ = trial_;
        best_weights_ = newton_.weights();
    }
    Eigen::VectorXf step_to_best() const {
        Eigen::VectorXf step = Eigen::VectorXf::Zero(n_variables());
        for (int s = 0; s < best_.cols(); ++s) {
            step.segment<Moving::kDimension>(kNumbers * s) =
                (best_.col(s) - from_targets_.col(s)).template cast<float>();
        }
        return step;
    }

    /// Sets x_i - t_i, unwrapped: the step is added for the number of periods, and the difference
    /// of the coordinates gives all digits.
    void place(const Eigen::VectorXf& direction, double t) {
        const auto& frame = moving_.frame();
        for (int s = 0; s < moving_.n_sites(); ++s) {
            Point at = from_targets_.col(s);
            if (t != 0) {
                at +=
                    t * direction.segment<Moving::kDimension>(kNumbers * s).template cast<double>();
            }
            const Point apart = moving_.coordinates().col(s) - targets_.col(s);
            const Point whole = (frame.to_lattice(at) - apart).array().round();
            trial_.col(s) = frame.to_position(Point(apart + whole));
        }
    }

    bool solve(double tolerance) {
        const SizeFigures now = newton_.solve(sizes_, tolerance, callback_);
        (*measure_)(newton_.diagram(), workers_, cells_);
        figures_.largest_relative_error = now.largest_relative_error;
        figures_.rounding = now.rounding;
        figures_.converged = now.converged || largest_error() <= tolerance;
        figures_.newton_steps += now.newton_steps;
        figures_.products += now.products;
        figures_.trials += now.trials;
        return figures_.converged || largest_error() <= kWorstTrial;
    }

    /// Values at trial_ and the cells.
    void fill(Evaluation& evaluation) {
        evaluation.value = -(cells_.value + newton_.weights().dot(sizes_ - cells_.mass));
        evaluation.gradient = -cells_.gradient;
        double largest = 0;
        double sum = 0;
        for (int s = 0; s < moving_.n_sites(); ++s) {
            const Point d = trial_.col(s);
            evaluation.value += sizes_[s] * d.squaredNorm();
            auto gradient = evaluation.gradient.segment<Moving::kDimension>(kNumbers * s);
            gradient += 2 * sizes_[s] * d;
            const double square = gradient.squaredNorm() / (4 * sizes_[s] * sizes_[s]);
            largest = std::max(largest, square);
            sum += square;
        }
        evaluation.residual = std::sqrt(largest) / moving_.spacing();
        rms_ = std::sqrt(sum / moving_.n_sites()) / moving_.spacing();
        evaluation.rms_residual = rms_;
    }

    /// g_i - t_i from the gradient.
    Eigen::VectorXd scaled(const Eigen::VectorXd& gradient) const {
        Eigen::VectorXd result(gradient.size());
        for (int s = 0; s < moving_.n_sites(); ++s) {
            result.segment<kNumbers>(kNumbers * s) =
                gradient.segment<kNumbers>(kNumbers * s) / (2 * sizes_[s]);
        }
        return result;
    }

    Moving& moving_;
    const Eigen::VectorXd& sizes_;
    Workers& workers_;
    const NewtonCallback& callback_;
    Measure* measure_;
    ShortestEdge* shortest_edge_;
    Derivatives* derivatives_;
    Pass pass_;
    Energy euclidean_;
    SizeNewton<Diagram> newton_;
    Energy cells_;
    SizeFigures figures_;
    /// The prescribed centroids, reduced basis.
    Points targets_;
    /// x_i - t_i of the point and of the trial, frame, units.
    Points from_targets_;
    Points trial_;
    /// The RMS distance of the centroids at the trial; its least value at a point, that point and
    /// its weights.
    double rms_ = 0;
    double best_rms_ = std::numeric_limits<double>::infinity();
    Points best_;
    Eigen::VectorXd best_weights_;
};

/// @param pairs  centroids within kNearestSites h of an earlier one.
/// @throws InvalidInput if there are any.
inline void require_apart(const std::vector<CoincidentSite>& pairs) {
    if (pairs.empty()) return;
    throw InvalidInput(
        "the centroids of grains " + std::to_string(pairs.front().earlier) + " and " +
        std::to_string(pairs.front().site) +
        " nearly coincide, which those of no power cells do; correct one of them, or "
        "merge the two grains");
}

/// Minimises a CentroidObjective, whose point is that of `moving`.
/// @param sizes  those of the objective.
template <class Moving>
RunStatistics fit_centroids(const Moving& moving, const Eigen::VectorXd& sizes,
                            Objective& objective, const RunOptions& run,
                            const DescentStep& newton_step = {}) {
    CentroidPatience patience;
    OptimizerOptions options = optimizer_options(moving, run);
    options.stop_when = [&](const Progress& now) { return patience.is_over(now); };
    if (run.progress) {
        const double unit = std::pow(moving.unit(), Moving::kDimension + 2);
        options.progress = [unit, &run](Progress now) {
            // Near the minimum this is the energy of the cells.
            now.value *= -unit;
            return run.progress(now);
        };
    }
    Eigen::VectorXd scales(objective.n_variables());
    for (int s = 0; s < moving.n_sites(); ++s) {
        scales.segment<Moving::kNumbersPerSite>(Moving::kNumbersPerSite * s)
            .setConstant(1 / (2 * sizes[s]));
    }
    RunStatistics ended = minimize_convex(objective, scales, options, newton_step).run;
    const bool is_fitted = ended.residual <= run.tolerance;
    if (ended.stop == Stop::kConverged && !is_fitted) ended.stop = Stop::kStalled;
    return ended;
}

}  // namespace pcvt
