#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "mesher/cells/cell_graph.hpp"
#include "mesher/plane/delaunay/moving_delaunay.hpp"
#include "mesher/plane/delaunay/periodic_delaunay.hpp"
#include "mesher/plane/power/power_cells.hpp"

namespace pcvt::plane {

/// The power diagram of the sites of a moving triangulation, with weights that change: the diagram
/// of SizeNewton (mesher/cvt/size_newton.hpp) in the plane. Flips lead from the triangulation of
/// earlier weights to that of others (power_flips.hpp).
///
/// Example usage:
///
///     PowerDiagram diagram(delaunay, workers);
///     diagram.start();
///     if (!diagram.set_weights(weights)) reject(weights);
///     const double largest_area = diagram.sizes().maxCoeff();
class PowerDiagram {
   public:
    using Moving = MovingDelaunay;
    /// Roundings of weights, and of the heights that follow from them, add up in one area: 64.
    static constexpr double kSizeRounding = 64 * kUnitRoundoff;
    static constexpr double kAimedRounding = 8 * kUnitRoundoff;
    /// Weights of an earlier call are tried as they are.
    static constexpr int kWarmTrials = 1;

    /// Both arguments must outlive this object; `delaunay` is restored and may move between calls
    /// of start().
    PowerDiagram(const MovingDelaunay& delaunay, Workers& workers)
        : delaunay_(&delaunay), workers_(&workers) {}

    int n_sites() const { return delaunay_->n_sites(); }

    /// Begins at the Delaunay triangulation of the sites, or at that of another diagram.
    void start() { regular_ = delaunay_->triangulation(); }
    void start(const PowerDiagram& other) { regular_ = other.regular_; }

    /// Makes the triangulation regular for the weights, and measures the cells.
    /// @param weights  in the order of `delaunay`, units^2.
    /// @returns false if a weight is not finite or a site is hidden; only weights() is of use then.
    bool set_weights(Eigen::VectorXd weights);

    const Eigen::VectorXd& weights() const { return weights_; }
    /// The areas of the cells, units^2.
    const Eigen::VectorXd& sizes() const { return areas_; }
    CellGraph graph() const;

    WeightedTriangulation regular() const {
        return {regular_, delaunay_->coordinates(), delaunay_->frame(), weights_};
    }
    /// The heights of measure_masses().
    const std::vector<double>& heights() const { return heights_; }

   private:
    const MovingDelaunay* delaunay_;
    Workers* workers_;
    TorusTriangulation regular_{0, {}};
    Eigen::VectorXd weights_;
    std::vector<double> heights_;
    Eigen::VectorXd areas_;
};

/// Turns a Delaunay triangulation that MovingDelaunay::release() gave into the regular one.
/// @param weights  of the sites in their order, length^2; no site is hidden.
PeriodicDelaunay weighted_delaunay(std::pair<Sites, TorusTriangulation> released,
                                   Eigen::VectorXd weights);

}  // namespace pcvt::plane
