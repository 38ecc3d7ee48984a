#pragma once

#include "mesher/lattice/lattice.hpp"

namespace pcvt {

/// A divergence-free periodic flow of known decay: a start for solvers of the Navier-Stokes
/// equations, and the answer to compare with.
///
///   psi = cos(g_1 . x) cos(g_2 . x) / |g_1|   rectangular period vectors (Taylor and Green)
///   psi = cos(g_2 . x) / |g_2|                oblique ones: a shear flow
///   u   = (d psi / dy, -d psi / dx)
///
/// g_1 and g_2 are the reciprocal vectors of the reduced basis, |g_1| >= |g_2|. Both flows solve
/// the equations for any viscosity nu as u(x, t) = exp(-nu rate t) u(x, 0). Laws, tested by number:
///   (1) u has the period of the lattice and its divergence is 0.
///   (2) The curl w of u is an eigenfunction: laplace(w) = -rate w, and u . grad(w) = 0.
///   (3) The largest speed is 1, in length units a second.
class DecayingFlow {
   public:
    /// @throws InvalidInput as reduce().
    explicit DecayingFlow(const Lattice& lattice);

    Vec2 velocity(const Vec2& p) const;
    /// sum of |g|^2 over the waves, 1 / length^2.
    double rate() const { return rate_; }
    /// The seconds in which the fastest fluid crosses a quarter of the shortest wave.
    double turn_time() const;

   private:
    Vec2 g1_;
    Vec2 g2_;
    double rate_;
    double fastest_;
    bool rectangular_;
};

}  // namespace pcvt
