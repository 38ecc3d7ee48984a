#pragma once

#include <vector>

#include "mesher/space/geometry/lattice.hpp"

namespace pcvt {

/// A divergence-free flow in space with the period of a lattice and a known decay, to test solvers
/// of the Navier-Stokes equations with:
///
///   u = sum over the shortest reciprocal vectors k of (e cos(k . x) + f sin(k . x)) / their number
///
/// where e, f and k / |k| are a right-handed orthonormal basis. The reciprocal vectors are those of
/// the reduced basis that have the least length, so that curl u = -|k| u and, for any viscosity nu,
/// u(x, t) = exp(-nu |k|^2 t) u(x, 0) solves the equations. In a cube u is an ABC flow (Arnold,
/// Beltrami and Childress).
///
/// Example usage:
///   const BeltramiFlow flow(mesh.lattice);
///   const space::Vec3 u = flow.velocity(p) * std::exp(-nu * flow.rate() * t);
///
/// Laws, tested by number:
///   (1) u has the period of the lattice and its speed is at most 1 length unit per second.
///   (2) curl u = -sqrt(rate) u.
class BeltramiFlow {
   public:
    explicit BeltramiFlow(const space::Lattice& lattice);

    space::Vec3 velocity(const space::Vec3& p) const;
    /// Returns the rate at which u decays with viscosity 1, 1 / length^2.
    double rate() const { return rate_; }
    /// Returns the time in which fluid with the speed 1 crosses a quarter of the wave, seconds.
    double turn_time() const;

   private:
    struct Wave {
        space::Vec3 k;
        space::Vec3 e;
        space::Vec3 f;
    };
    std::vector<Wave> waves_;
    double rate_ = 0;
};

}  // namespace pcvt
