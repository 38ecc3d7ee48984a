#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "mesher/base/error.hpp"
#include "mesher/cvt/centroid_figures.hpp"
#include "mesher/cvt/cvt_objective.hpp"
#include "mesher/cvt/size_newton.hpp"
#include "mesher/portable/portable_functions.hpp"

namespace pcvt {

/// Prescribed centroids and sites that are fitted to them stay this far from each other, in units
/// of h: cells of sites whose coordinates are rounded, by 2^-50 of a period, are still exact to
/// 1e-9 of the mean size then.
inline constexpr double kNearestSites = 1e-5;

/// Two sites that an edge of the Delaunay triangulation joins.
template <int D>
struct SitePair {
    SiteId from;
    SiteId to;
    /// From the one to the other, units.
    Eigen::Vector<double, D> apart;
};

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
/// L-BFGS minimises P from x = t in space. In units of 2 s_i its Hessian is near to the identity,
/// so that the first step is t_i - g_i. P is hardly curved towards sites that come close to each
/// other and has a kink where they meet, at which L-BFGS stops in the plane. There P is minimised
/// along a path, from c = 1 to c = 0, of the minima of
///
///   P_c(x)  =  P(x)  +  c sum over i of s_i |x_i - t_i|^2
///                    +  c k h^2 sum over pairs of min(s_i, s_j) (r^2 / R^2 - 1 - 2 ln(r / R))
///
/// The first term keeps the sites near t, the second keeps pairs apart that are nearer than R:
/// r = |x_i - x_j| < R, R = 0.2 h, k = 0.1.
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
    using Pair = SitePair<Moving::kDimension>;
    /// Pairs of sites, once each, among them each site with its nearest one, and those nearer than
    /// R where pull() is used.
    using Pairs = std::vector<Pair>(const Moving& moving);

    /// R in h.
    static constexpr double kReach = 0.2;

    /// All arguments but the functions must outlive this object.
    /// @param moving  its sites are the prescribed centroids.
    /// @param sizes   s_i in the unit and the order of `moving`, with the sum of the domain's size.
    CentroidObjective(Moving& moving, const Eigen::VectorXd& sizes, Workers& workers,
                      const NewtonCallback& callback, Measure* measure, Pairs* find_pairs)
        : moving_(moving),
          sizes_(sizes),
          workers_(workers),
          callback_(callback),
          measure_(measure),
          find_pairs_(find_pairs),
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
        pairs_ = find_pairs_(moving_);
        if (t != 0 && shortest_pair() < kNearestSites * moving_.spacing()) return false;
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

    /// c, zero at first; counts from the next call of evaluate() on.
    void set_pull(double pull) { pull_ = pull; }
    double pull() const { return pull_; }
    /// The RMS length of grad P_c over 2 s_i, in h, at the last evaluation.
    double rms_slope() const { return rms_slope_; }
    /// The geometric mean of the distances |g_i - t_i| at the last evaluation, in h.
    double typical_misfit() const { return typical_misfit_; }
    /// At the last evaluation.
    const std::vector<Pair>& pairs() const { return pairs_; }
    /// k min(s_i, s_j) h^2 of a pair nearer than R, which adds c times this number times
    /// (1 / R^2 + 1 / r^2) d d^T / r^2 to half the Hessian between its sites, where that is
    /// positive definite, else 0.
    double repulsion(const Pair& pair) const {
        if (!(pair.apart.squaredNorm() < reach_squared())) return 0;
        return kRepulsion * std::min(sizes_[pair.from], sizes_[pair.to]) * moving_.spacing() *
               moving_.spacing();
    }
    /// R^2
    double reach_squared() const { return std::pow(kReach * moving_.spacing(), 2); }
    const Moving& moving() const { return moving_; }
    const Eigen::VectorXd& sizes() const { return sizes_; }
    Workers& workers() const { return workers_; }
    /// Undoes the last trial.
    /// @returns false if it cannot be undone.
    bool return_to_point() { return undo_step(); }

    /// Goes to the point of the run with the nearest centroids, which need not be the last one, and
    /// solves for the sizes there, to a tolerance of their mean.
    /// @returns the figures of the centroids.
    /// @throws InvalidInput if the sizes are not reached.
    CentroidFigures finish(double tolerance) {
        undo_step();
        pull_ = 0;
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
    /// k
    static constexpr double kRepulsion = 0.1;

    bool undo_step() {
        if (moving_.settled()) return true;
        moving_.step_back();
        return Moving::kStepsUnrestored || pass_.evaluate(euclidean_);
    }

    double shortest_pair() const {
        double least = std::numeric_limits<double>::infinity();
        for (const Pair& pair : pairs_) least = std::min(least, pair.apart.squaredNorm());
        return std::sqrt(least);
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
        double logarithms = 0;
        for (int s = 0; s < moving_.n_sites(); ++s) {
            const Point d = trial_.col(s);
            evaluation.value += sizes_[s] * d.squaredNorm();
            auto gradient = at_site(evaluation.gradient, s);
            gradient += 2 * sizes_[s] * d;
            const double square = gradient.squaredNorm() / (4 * sizes_[s] * sizes_[s]);
            largest = std::max(largest, square);
            sum += square;
            logarithms += portable_log(std::max(square, std::numeric_limits<double>::min()));
        }
        evaluation.residual = std::sqrt(largest) / moving_.spacing();
        rms_ = std::sqrt(sum / moving_.n_sites()) / moving_.spacing();
        evaluation.rms_residual = rms_;
        typical_misfit_ = portable_exp(logarithms / (2 * moving_.n_sites())) / moving_.spacing();
        if (pull_ > 0) add_pull(evaluation);
    }

    void add_pull(Evaluation& evaluation) {
        for (int s = 0; s < moving_.n_sites(); ++s) {
            const Point d = trial_.col(s);
            evaluation.value += pull_ * sizes_[s] * d.squaredNorm();
            at_site(evaluation.gradient, s) += 2 * pull_ * sizes_[s] * d;
        }
        for (const Pair& pair : pairs_) {
            const double weight = pull_ * repulsion(pair);
            if (weight == 0) continue;
            const double r2 = pair.apart.squaredNorm();
            const double part = r2 / reach_squared();
            evaluation.value += weight * (part - 1 - portable_log(part));
            const Point slope = 2 * weight * (1 / reach_squared() - 1 / r2) * pair.apart;
            at_site(evaluation.gradient, pair.to) += slope;
            at_site(evaluation.gradient, pair.from) -= slope;
        }
        rms_slope_ = scaled(evaluation.gradient).norm() / std::sqrt(double(moving_.n_sites())) /
                     moving_.spacing();
    }
    static auto at_site(Eigen::VectorXd& numbers, int site) {
        return numbers.segment<Moving::kDimension>(kNumbers * site);
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
    Pairs* find_pairs_;
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
    std::vector<Pair> pairs_;
    double pull_ = 0;
    double rms_slope_ = 0;
    double typical_misfit_ = 0;
    /// The RMS distance of the centroids at the trial; its least value at a point, that point and
    /// its weights.
    double rms_ = 0;
    double best_rms_ = std::numeric_limits<double>::infinity();
    Points best_;
    Eigen::VectorXd best_weights_;
};

}  // namespace pcvt
