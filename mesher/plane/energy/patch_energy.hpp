#pragma once

#include <array>
#include <vector>

#include "mesher/cvt/energy.hpp"
#include "mesher/plane/delaunay/delaunay_patch.hpp"
#include "mesher/plane/energy/triangle_terms.hpp"

namespace pcvt::plane {

/// The energy of a patch for rho = 1, up to a constant while no flip changes its border; its
/// gradient and the masses at the sites that move are those of the whole triangulation.
///
/// The terms are those of EnergyPass (energy.hpp). A patch fits into the processor's cache, so that
/// a pass waits for no memory.
///
/// Example usage:
///
///     PatchPass pass(patch, workers);
///     Energy energy;
///     if (pass.evaluate(energy)) use(energy.gradient);
class PatchPass {
   public:
    using Moving = DelaunayPatch;

    /// The patch must outlive this object; the pass runs on the calling thread.
    PatchPass(DelaunayPatch& patch, Workers& workers);

    /// Restores the triangulation of the patch after a step, and evaluates.
    /// @returns false if a triangle is inverted or very thin.
    bool evaluate(Energy& energy);

   private:
    bool run();
    void add_terms(int first, int n, const TriangleBlock& block);

    DelaunayPatch& patch_;
    double value_ = 0;
    /// For each site of the patch: the gradient, x and y, and the mass.
    std::vector<std::array<double, 3>> sums_;
    std::vector<int> suspects_;
};

}  // namespace pcvt::plane
