#pragma once

#include "mesher/lattice/lattice.hpp"

namespace pcvt {

/// A divergence-free periodic flow with a known decay: an initial state for solvers of the
/// Navier-Stokes equations, and the exact solution to compare with.
///
///   psi = cos(g_1 . x) cos(g_2 . x) / |g_1|   rectangular period vectors (Taylor and Green)
///   psi = cos(g_2 . x) / |g_2|                oblique ones: a shear flow
///   u   = (d psi / dy, -d psi / dx)
///
/// where g_1 and g_2 are the reciprocal vectors of the reduced basis, |g_1| >= |g_2|. For any
/// viscosity nu both flows solve the equations as u(x, t) = exp(-nu rate t) u(x, 0).
///
/// Example usage:
///   const DecayingFlow flow(lattice);
///   const Vec2 u = flow.velocity(p) * std::exp(-nu * flow.rate() * t);
///
/// Laws, tested by number:
///   (1) u has the period of the lattice and its divergence is 0.
///   (2) The curl w of u is an eigenfunction: laplace(w) = -rate w, and u . grad(w) = 0.
///   (3) The largest speed is 1 length unit per second.
///   (4) stream(q) - stream(p) is the area per second that crosses the segment pq to its right.
class DecayingFlow {
   public:
    /// @throws InvalidInput as reduce().
    explicit DecayingFlow(const Lattice& lattice);

    Vec2 velocity(const Vec2& p) const;
    /// Returns psi(p), length^2 / second.
    double stream(const Vec2& p) const;
    double largest_stream() const { return 1 / fastest_; }
    /// Returns the mean of |u|^2 over the domain.
    double mean_square_speed() const;
    /// Returns the sum of |g|^2 over the waves, 1 / length^2.
    double rate() const { return rate_; }
    /// Returns the time in which the fastest fluid crosses a quarter of the shortest wave, seconds.
    double turn_time() const;

   private:
    Vec2 g1_;
    Vec2 g2_;
    double rate_;
    double fastest_;
    bool rectangular_;
};

}  // namespace pcvt
