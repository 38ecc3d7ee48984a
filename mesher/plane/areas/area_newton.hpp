#pragma once

#include <Eigen/Core>
#include <functional>

#include "mesher/plane/areas/weight_orbits.hpp"
#include "mesher/plane/delaunay/moving_delaunay.hpp"
#include "mesher/plane/power/power_cells.hpp"

namespace pcvt::plane {

/// The figures of AreaNewton::solve.
struct AreaFigures {
    /// max |m_i - a_i| / a_i
    double largest_relative_error = 0;
    int newton_steps = 0;
    /// Products with the Laplacian, and triangulations of trial weights.
    int products = 0;
    int trials = 0;
    /// A bound of the relative error by the rounding of double weights: an area changes with a
    /// weight by l / 2 d, the length of an edge over twice the distance of its sites. Computed, and
    /// above the usual tolerance, only where sites are much closer to each other than the cells are
    /// long.
    double rounding = 0;
    /// Whether the error is below the tolerance or the rounding.
    bool converged = false;
};

/// Called before the first step and after each one; an exception ends the iteration.
using NewtonCallback = std::function<void(const AreaFigures&)>;

/// Finds the weights that give the power cells of fixed sites prescribed areas.
///
/// The weights maximise the concave function (F. Aurenhammer, F. Hoffmann, B. Aronov 1998)
///
///   g(w)  =  sum over i of [ w_i a_i + integral over cell i of (|p - x_i|^2 - w_i) ],
///
/// whose gradient is a - m and whose Hessian is minus the Laplacian of the cells' adjacency
/// (power_cells.hpp). Newton's method is damped (J. Kitagawa, Q. Merigot, B. Thibert 2019): a step
/// is halved until every cell keeps at least half of the least area, that of the targets and of
/// the start, and the error |a - m| falls by the factor 1 - t / 2. A step that would hide a cell is
/// found by PowerFlips and halved as well.
///
/// Example usage:
///
///     AreaNewton newton(delaunay, workers);
///     const AreaFigures figures = newton.solve(targets, 1e-10);
///     const Eigen::VectorXd& weights = newton.weights();
///
/// Laws, tested by number:
///   (1) max |m_i - a_i| / a_i <= max(`tolerance`, rounding), for any sites, n >= 1 and positive
///       targets that sum to the area of the domain.
///   (2) The weights sum to zero, and equal targets on a lattice give equal weights.
///   (3) Every bit is the same for any number of workers.
///   (4) The weights of an orbit are equal to the last bit.
class AreaNewton {
   public:
    /// @param delaunay  restored; it must outlive this object and may move between calls.
    /// @param orbits    of the sites of `delaunay`, which map to each other with their targets.
    AreaNewton(const MovingDelaunay& delaunay, Workers& workers, WeightOrbits orbits = {});

    /// Starts from the weights of the last call where they give every site a cell, else from 0.
    /// @param areas  a_i in units^2 and the order of `delaunay`, positive, with the sum of the
    ///               domain's area.
    AreaFigures solve(const Eigen::VectorXd& areas, double tolerance,
                      const NewtonCallback& callback = {});

    /// In units^2.
    const Eigen::VectorXd& weights() const { return here_.weights; }
    const Eigen::VectorXd& masses() const { return here_.mass; }
    /// The regular triangulation at the sites and the weights.
    WeightedTriangulation diagram() const { return diagram(here_); }
    const std::vector<double>& heights() const { return here_.heights; }

   private:
    /// Weights, with the diagram of the current sites.
    struct State {
        TorusTriangulation regular{0, {}};
        Eigen::VectorXd weights;
        std::vector<double> heights;
        Eigen::VectorXd mass;
    };

    WeightedTriangulation diagram(const State& state) const {
        return {state.regular, delaunay_.coordinates(), delaunay_.frame(), state.weights};
    }
    bool restore(State& state) const;
    /// The adjacency of the orbits of cells.
    CellGraph graph() const;
    double rounding(const Eigen::VectorXd& areas) const;
    void begin(double least_area);
    enum class Outcome { kAccepted, kRounding, kTooShort };
    Outcome search(const Eigen::VectorXd& areas, const Eigen::VectorXd& direction, double shortest,
                   double least_mass, AreaFigures& figures);
    bool step(const Eigen::VectorXd& areas, double tolerance, double least_mass,
              AreaFigures& figures);

    const MovingDelaunay& delaunay_;
    Workers& workers_;
    WeightOrbits orbits_;
    State here_;
    State trial_;
    double last_step_ = 1;
};

}  // namespace pcvt::plane
