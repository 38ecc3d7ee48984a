#pragma once

#include <vector>

#include "mesher/base/workers.hpp"
#include "mesher/optimize/fixed_blocks.hpp"
#include "mesher/plane/delaunay/moving_delaunay.hpp"

namespace pcvt::plane {

/// The end of a minimisation for rho = 1, in which few sites are far from the tolerance.
///
/// After some 100 iterations nearly all residuals are below a tolerance of 1e-3, except near cells
/// without six sides, where sites still rearrange. A round moves only the active sites: those with
/// larger residuals and the rings of sites round them. They form patches (delaunay_patch.hpp), each
/// of which has its own minimiser, with its own steps and history, while all other sites stay. A
/// site at the edge of a patch gets a residual when the patch relaxes; it is active in the next
/// round if the residual is too large.
///
/// Example usage (before each iteration, with the gradient and the masses at the current point):
///
///     ActiveSites active(delaunay, workers, fixed);
///     if (active.relax(gradient, mass, 1e-3)) pass.evaluate(energy);  // all sites
///
/// Laws, tested by number:
///   (1) A round does not raise the energy.
///   (2) Fixed sites, and all sites that are far from large residuals, stay where they are, to the
///       last bit.
///   (3) Every bit is the same for any number of workers.
class ActiveSites {
   public:
    /// All arguments must outlive this object.
    ActiveSites(MovingDelaunay& delaunay, Workers& workers, const FixedBlocks& fixed);

    /// Must be called before each iteration. Runs one round where this takes less time than
    /// iterations with all sites would.
    /// @param gradient   zero at fixed sites.
    /// @param tolerance  of the residuals, in units of h.
    /// @returns whether sites have moved. The triangulation is then restored inside of the patches,
    ///          and the energy must be evaluated.
    bool relax(const Eigen::VectorXd& gradient, const Eigen::VectorXd& mass, double tolerance);

   private:
    std::vector<SiteId> sites_above(double residual, const Eigen::VectorXd& gradient,
                                    const Eigen::VectorXd& mass) const;
    void run_round(const std::vector<SiteId>& first, double tolerance);

    MovingDelaunay& delaunay_;
    Workers& workers_;
    const FixedBlocks& fixed_;
    int n_rounds_ = 0;
    /// The calls since the last round or count, and the number of them before the next.
    int n_waited_ = 0;
    int n_to_wait_;
};

}  // namespace pcvt::plane
