#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "mesher/cells/cell_graph.hpp"
#include "mesher/space/delaunay/moving_tetrahedra.hpp"
#include "mesher/space/power/power_cells.hpp"

namespace pcvt::space {

/// Counts of PowerDiagram::set_weights.
struct PowerCounts {
    std::int64_t n_flips = 0;
    /// Calls that ended at a hidden site.
    int n_hidden = 0;
    /// Ways that were halved because flips got stuck.
    int n_halvings = 0;
};

/// The power diagram of the sites of moving tetrahedra, with weights that change: the diagram of
/// SizeNewton (mesher/cvt/size_newton.hpp) in space. Flips lead from the tetrahedra of earlier
/// weights to those of others (power_flips.hpp).
///
/// Flips get stuck on some long ways. Then the way is halved: the tetrahedra go back to the last
/// weights at which they were regular, and to the new ones over weights in between. The cell of a
/// site at (1 - t) w + t w' contains the Minkowski sum of (1 - t) times its cell at w and t times
/// its cell at w', so that no cell vanishes between two weights at which all sites have cells (the
/// cube root of its volume is concave, by Brunn and Minkowski).
///
/// Example usage:
///
///     PowerDiagram diagram(moving, workers);
///     diagram.start();
///     if (!diagram.set_weights(weights)) reject(weights);
///     const double largest_volume = diagram.sizes().maxCoeff();
class PowerDiagram {
   public:
    using Moving = MovingTetrahedra;
    /// One rounding of each weight; volumes are measured to 1e-11 of their mean or so.
    static constexpr double kSizeRounding = 0x1p-53;
    static constexpr double kAimedRounding = kSizeRounding;
    /// Weights of earlier sites may hide some: halves of them are tried so often.
    static constexpr int kWarmTrials = 6;

    /// Both arguments must outlive this object; `moving` is restored and may move between calls of
    /// start().
    PowerDiagram(const MovingTetrahedra& moving, Workers& workers)
        : moving_(&moving), workers_(&workers) {}

    int n_sites() const { return moving_->n_sites(); }

    /// Begins at the Delaunay tetrahedra of the sites, or at those of another diagram.
    void start();
    void start(const PowerDiagram& other);

    /// Makes the tetrahedra regular for the weights, and measures the cells.
    /// @param weights  in the order of `moving`, units^2. Only differences count; the largest
    /// weight
    ///                 should not be far from zero.
    /// @returns false if a weight is not finite or above kLargestWeight in the unit of the
    ///          predicates, or if a site is hidden; only weights() and hidden_site() are of use
    ///          before the next start() then.
    bool set_weights(Eigen::VectorXd weights);
    /// The hidden site, in the order of `moving`, at which the last call of set_weights() ended.
    std::optional<SiteId> hidden_site() const { return hidden_; }

    const Eigen::VectorXd& weights() const { return weights_; }
    /// The volumes of the cells, units^3.
    const Eigen::VectorXd& sizes() const { return volumes_; }
    CellGraph graph() const { return cell_graph(regular()); }

    WeightedTetrahedra regular() const {
        return {*tetrahedra_, moving_->coordinates(), moving_->frame(), weights_};
    }
    const TorusTetrahedra& tetrahedra() const { return *tetrahedra_; }
    const PowerCounts& counts() const { return counts_; }

   private:
    enum class Outcome { kRegular, kHidden, kStuck };
    std::optional<SiteId> site_without_cell(const Eigen::VectorXd& weights) const;
    Outcome flip_to(const Eigen::VectorXd& weights);
    bool go_to(const Eigen::VectorXd& weights);
    void copy_from(const TorusTetrahedra& other);

    const MovingTetrahedra* moving_;
    Workers* workers_;
    /// Where the way to the next weights begins: tetrahedra that are regular for these weights.
    /// They may belong to other diagrams as well; null where tetrahedra_ are these.
    std::shared_ptr<const TorusTetrahedra> base_;
    Eigen::VectorXd base_weights_;
    std::shared_ptr<TorusTetrahedra> tetrahedra_;
    /// The flips of tetrahedra_ since they were sorted.
    std::int64_t n_flips_unsorted_ = 0;
    std::int64_t base_flips_unsorted_ = 0;
    Eigen::VectorXd weights_;
    Eigen::VectorXd volumes_;
    VolumeSums sums_;
    std::optional<SiteId> hidden_;
    PowerCounts counts_;
};

/// Returns the sites and the regular tetrahedra of a diagram, with its weights in length units, in
/// the numbering of the constructor's argument of `moving`.
/// @param moving   that of the diagram, at the same positions; must not be used afterwards.
PeriodicDelaunay weighted_delaunay(MovingTetrahedra& moving, const PowerDiagram& diagram);

}  // namespace pcvt::space
