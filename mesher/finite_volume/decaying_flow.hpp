#pragma once

#include "mesher/plane/geometry/walled_domain.hpp"

namespace pcvt {

/// A divergence-free flow, periodic or between walls, with a known decay: an initial state for
/// solvers of the Navier-Stokes equations, and the exact solution to compare with.
///
///   psi = cos(g_1 . x) cos(g_2 . x) / |g_1|   rectangular period vectors (Taylor and Green)
///   psi = cos(g_2 . x) / |g_2|                oblique ones: a shear flow
///   psi = -cos(pi y / H) H / pi               walls across y: u = (sin(pi y / H), 0)
///   psi = cos(pi x / W) W / pi                walls across x: u = (0, sin(pi x / W))
///   psi = sin^2(pi x / W) sin^2(pi y / H) min(W, H) / pi   walls all round
///   u   = (d psi / dy, -d psi / dx)
///
/// where g_1 and g_2 are the reciprocal vectors of the reduced basis, |g_1| >= |g_2|, and W x H is
/// the domain between walls. For any viscosity nu these flows solve the equations as
/// u(x, t) = exp(-nu rate t) u(x, 0); only the one with walls all round changes its shape, and just
/// begins to lose its energy with this rate.
///
/// Example usage:
///   const DecayingFlow flow(tile.lattice, tile.walls);
///   const Vec2 u = flow.velocity(p) * std::exp(-nu * flow.rate() * t);
///
/// Laws, tested by number:
///   (1) u has the period of the lattice along the walls, or along both axes without walls, and its
///       divergence is 0.
///   (2) The curl w of u is an eigenfunction: laplace(w) = -rate w, and u . grad(w) = 0; with walls
///       all round, rate is the mean of w^2 divided by that of |u|^2.
///   (3) The largest speed is 1 length unit per second.
///   (4) stream(q) - stream(p) is the area per second that crosses the segment pq to its right.
///   (5) u is 0 on walls.
class DecayingFlow {
   public:
    /// @pre with walls, is_upright(lattice).
    /// @throws InvalidInput as reduce().
    explicit DecayingFlow(const plane::Lattice& lattice, Walls walls = Walls::kNone);

    plane::Vec2 velocity(const plane::Vec2& p) const;
    /// Returns psi(p), length^2 / second.
    double stream(const plane::Vec2& p) const;
    double largest_stream() const { return 1 / fastest_; }
    /// Returns the mean of |u|^2 over the domain.
    double mean_square_speed() const;
    /// Returns the rate at which u decays with viscosity 1, 1 / length^2.
    double rate() const;
    /// Whether u keeps its shape, and this rate.
    bool keeps_shape() const { return shape_ != Shape::kBox; }
    /// Returns the time in which the fastest fluid crosses a quarter of the shortest wave, seconds.
    double turn_time() const;

   private:
    /// psi is a product of cosines, the cosine of g2_ . x, or a product of squared sines.
    enum class Shape { kVortices, kShear, kBox };

    void choose_periodic(const plane::Lattice& lattice);
    void choose_between(const plane::Lattice& domain, Walls walls);

    plane::Vec2 g1_;
    plane::Vec2 g2_;
    Shape shape_;
    double sign_ = 1;
    /// The length of the wave vector across which the velocity is 1.
    double fastest_;
};

}  // namespace pcvt
