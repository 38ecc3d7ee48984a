#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <optional>

#include "mesher/base/workers.hpp"
#include "mesher/cells/cell_graph.hpp"
#include "mesher/cells/laplacian_solver.hpp"
#include "mesher/cells/weight_orbits.hpp"

namespace pcvt {

/// The figures of SizeNewton::solve. A size is an area in the plane and a volume in space.
struct SizeFigures {
    /// max |m_i - s_i| / s_i
    double largest_relative_error = 0;
    int newton_steps = 0;
    /// Products with the Laplacian, and triangulations of trial weights.
    int products = 0;
    int trials = 0;
    /// The largest r_i / s_i, a bound of the relative error by rounding (SizeNewton). Computed, and
    /// above the usual tolerance, only where sites are much closer to each other than the cells are
    /// long.
    double rounding = 0;
    /// Whether the error of each cell is below the tolerance or the rounding.
    bool converged = false;
};

/// Called before the first step and after each one; an exception ends the iteration.
using NewtonCallback = std::function<void(const SizeFigures&)>;

/// Finds the weights that give the power cells of fixed sites prescribed sizes.
///
/// The weights maximise the concave function (F. Aurenhammer, F. Hoffmann, B. Aronov 1998)
///
///   g(w)  =  sum over i of [ w_i s_i + integral over cell i of (|p - x_i|^2 - w_i) ],
///
/// whose gradient is s - m, with m the sizes of the cells, and whose Hessian is minus the Laplacian
/// of the cells' adjacency (cell_graph.hpp). Newton's method is damped (J. Kitagawa, Q. Merigot, B.
/// Thibert 2019): a step t is shortened until no cell is hidden, every cell keeps at least half of
/// the least size, that of the targets and of the start, and the error falls by the factor 1 - t
/// / 2.
///
/// Far from the solution, steps solve the equations sqrt(m_i) = sqrt(s_i) instead of m_i = s_i,
/// because the size of a cell whose neighbours stay grows with its weight like a power above one.
/// Their linear form aims at the change of sizes
///
///   2 (L sqrt(m_i s_i) - m_i),   L = sum of m / sum of sqrt(m_i s_i) >= 1,
///
/// and the error is |sqrt(s) - sqrt(m)|, which falls by a factor near 1 - t along each such step.
/// This saves a fifth to a third of the steps.
///
/// Weights are doubles. The size m_i changes with the weight w_j by the conductance c_ij, the
/// length or area of the common side over twice the distance of its sites. A step rounds each
/// weight once, by at most 2^-53 |w|, so that doubles need not hold weights whose sizes are nearer
/// to their targets than
///
///   r_i  =  k 2^-53 sum over the neighbours j of c_ij (|w_i| + |w_j|),
///
/// where k = 1 if sizes are measured without an error of that magnitude. Steps are judged by the
/// largest |m_i - s_i| over the tolerance or r_i where errors are that small, so that cells between
/// near sites, which stay at their rounding, do not keep others from their targets.
///
/// `Diagram` is the power diagram of the sites of a `Diagram::Moving`, copied and swapped freely,
/// with weights of its own (plane::PowerDiagram):
///
///   Diagram(moving, workers)   without weights
///   n_sites()                  their number
///   start()                    begins at the Delaunay triangulation of the sites
///   start(other)               begins at the triangulation of another diagram of these sites
///   set_weights(weights)       measures the cells; false if a site has none
///   weights(), sizes()         w and m, by site
///   graph()                    the adjacency of the cells
///   kSizeRounding              k 2^-53
///   kAimedRounding             the same for sizes that a few more steps reach
///   kWarmTrials                how often weights of an earlier call, then halves of them, are
///   tried
///                              at the beginning
///
/// Example usage:
///
///     SizeNewton<plane::PowerDiagram> newton(delaunay, workers);
///     const SizeFigures figures = newton.solve(targets, 1e-10);
///     const Eigen::VectorXd& weights = newton.weights();
///
/// Laws, tested by number:
///   (1) |m_i - s_i| <= max(`tolerance` s_i, r_i), for any sites, n >= 1 and positive targets that
///       sum to the size of the domain.
///   (2) The weights sum to zero, and equal targets on a lattice give equal weights.
///   (3) Every bit is the same for any number of workers.
///   (4) The weights of an orbit are equal to the last bit.
///
/// size_newton_definitions.hpp has the definitions.
template <class Diagram>
class SizeNewton {
   public:
    using Moving = typename Diagram::Moving;

    /// @param moving  restored; it must outlive this object and may move between calls.
    /// @param orbits  sites of `moving` that map to each other with their targets.
    SizeNewton(const Moving& moving, Workers& workers, WeightOrbits orbits = {});

    /// Starts from the weights of the last call, or from a half, a quarter and so on of them, where
    /// they give every site a cell, else from 0.
    /// @param targets  s_i in the unit of `moving` and its order, positive, with the sum of the
    ///                 domain's size.
    SizeFigures solve(const Eigen::VectorXd& targets, double tolerance,
                      const NewtonCallback& callback = {});
    /// The next call of solve() starts from these weights instead of those of the last call.
    void start_next_from(const Eigen::VectorXd& weights) { warm_ = weights; }

    /// In units^2.
    const Eigen::VectorXd& weights() const { return here_.weights(); }
    const Eigen::VectorXd& sizes() const { return here_.sizes(); }
    const Diagram& diagram() const { return here_; }
    /// The largest r_i in the unit of sizes(), for the present weights.
    double rounding() const { return orbit_roundings(graph(), Diagram::kSizeRounding).maxCoeff(); }

   private:
    /// The adjacency of the orbits of cells.
    CellGraph graph() const { return orbits_.merged(here_.graph()); }
    Eigen::VectorXd orbit_roundings(const CellGraph& cells, double of_weight) const;
    /// The largest error over the tolerance or the rounding of its cell.
    double excess(const Eigen::VectorXd& sizes, const Eigen::VectorXd& targets,
                  double tolerance) const;
    void begin(double least_target);
    enum class Outcome { kAccepted, kRounding, kTooShort };
    /// One call of solve().
    struct Iteration {
        const Eigen::VectorXd& targets;
        double tolerance;
        double least_size;
        SizeFigures figures = {};
        /// |s - m| before the last step.
        double last_error = 0;
        /// The hierarchy of an earlier step, and the error of the sizes when it was built.
        std::optional<LaplacianSolver> solver = {};
        double solver_error = std::numeric_limits<double>::infinity();
    };
    double distance(const Iteration& now, const Eigen::VectorXd& sizes, bool is_far) const;
    Eigen::VectorXd aim(const Iteration& now, const Eigen::VectorXd& error) const;
    static double accuracy(const Iteration& now, double error);
    static LaplacianSolver& prepare(Iteration& now, const CellGraph& cells, double error);
    Outcome search(Iteration& now, const Eigen::VectorXd& direction, double shortest);
    bool step(Iteration& now);

    WeightOrbits orbits_;
    Diagram here_;
    Diagram trial_;
    /// The weights from which the next call of solve() starts, if they are not those of here_.
    Eigen::VectorXd warm_;
    /// r_i by site, for the roundings that steps aim at.
    Eigen::VectorXd roundings_;
    double last_step_ = 1;
};

}  // namespace pcvt
