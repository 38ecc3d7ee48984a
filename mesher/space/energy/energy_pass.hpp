#pragma once

#include "mesher/space/energy/energy.hpp"

namespace pcvt::space {

/// The energy of moving sites. The pass that evaluates it also certifies the triangulation.
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
    bool correct(ExchangedTetrahedra exchanged, Energy& energy) const;

    MovingTetrahedra& moving_;
    Workers& workers_;
    EnergySums sums_;
};

}  // namespace pcvt::space
