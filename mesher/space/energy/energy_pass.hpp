#pragma once

#include "mesher/base/workers.hpp"
#include "mesher/space/delaunay/moving_tetrahedra.hpp"
#include "mesher/space/energy/energy.hpp"

namespace pcvt::space {

/// Evaluates the energy of moving sites, and certifies or restores the triangulation in the same
/// pass.
///
/// Example usage:
///
///     EnergyPass pass(moving, workers);
///     Energy energy;
///     if (!pass.evaluate(energy)) throw InvalidInput("two sites coincide");
class EnergyPass {
   public:
    using Moving = MovingTetrahedra;

    /// Both arguments must outlive this object.
    EnergyPass(MovingTetrahedra& moving, Workers& workers) : moving_(moving), workers_(workers) {}

    /// Restores the triangulation after a step, and evaluates. The energy is corrected for the
    /// tetrahedra that the repair exchanged, unless they are so numerous, or so large compared with
    /// F, that a second pass is better.
    /// @returns false if two sites coincide: the only valid next call is then
    ///          MovingTetrahedra::step_back.
    bool evaluate(Energy& energy);

   private:
    Suspects violations(Energy& energy);
    /// Repairs the triangulation, and corrects the energy.
    /// @returns false if the triangulation must be built from scratch.
    bool restore(Suspects wrong, Energy& energy);
    /// Corrects the energy for exchanged tetrahedra if this costs less than another pass.
    /// @returns false if another pass must compute it.
    bool correct(ExchangedTetrahedra exchanged, Energy& energy) const;

    MovingTetrahedra& moving_;
    Workers& workers_;
    EnergySums sums_;
};

}  // namespace pcvt::space
