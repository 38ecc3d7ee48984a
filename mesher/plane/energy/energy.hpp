#pragma once

#include "mesher/cvt/energy.hpp"
#include "mesher/plane/delaunay/moving_delaunay.hpp"

namespace pcvt::plane {

/// The periodic CVT energy and its gradient (paper, Eqs. 2 and 3) for rho = 1.
///
///   F(x)    = sum_i  integral over cell i of  |p - x_i|^2
///   dF/dx_i = 2 m_i (x_i - g_i)
///
///   paper | code
///   x_i   | MovingDelaunay::coordinates
///   F     | Energy::value
///   m_i   | Energy::mass
///   g_i   | x_i - gradient_i / (2 m_i), the centroid
///
/// One pass over the Delaunay triangles computes all of this without circumcentres or polygons. The
/// part of cell i that belongs to the directed edge (i, j) of a triangle is the right-angled
/// triangle between x_i, the midpoint of the edge and the circumcentre, with a negative sign where
/// the opposite angle is obtuse. With l = |x_j - x_i|^2 and c the cotangent of the opposite angle,
/// the edge adds l^2 c (3 + c^2) / 96 to F and l c / 8 to the masses of both sites. The sum is
/// exact on a Delaunay triangulation, and the same pass certifies that the triangulation is
/// Delaunay.
///
/// Example usage:
///
///     EnergyPass pass(delaunay, workers);
///     Energy energy;
///     if (!pass.evaluate(energy)) throw InvalidInput("two sites coincide");
///     const double largest = residuals(energy.gradient, energy.mass, h, workers).largest;
///
/// Laws, tested by number:
///   (1) F is unchanged when any site moves by a lattice translation.
///   (2) The gradient sums to zero over the sites.
///   (3) F >= 5 A^2 / (18 sqrt(3) n), A the area of the domain.
///   (4) The masses sum to A.
///   (5) Every bit is the same for any number of workers.
class EnergyPass final : private FlipObserver {
   public:
    using Moving = MovingDelaunay;

    /// Both arguments must outlive this object.
    EnergyPass(MovingDelaunay& delaunay, Workers& workers);
    ~EnergyPass();

    /// Restores the triangulation after a step, and evaluates. The terms of flipped triangles are
    /// corrected one by one, unless they are so numerous, or so large compared with F, that a
    /// second pass is better.
    /// @returns false if two sites coincide.
    bool evaluate(Energy& energy);

   private:
    struct Slab;

    void before_flip(int h) override;
    void after_flip(int h) override;
    void fetch(SiteId site) const override;
    Suspects run(Energy& energy);
    bool corrections_pay() const;
    bool corrections_are_exact() const;
    void add_terms(int triangle, double sign);

    MovingDelaunay& delaunay_;
    Workers& workers_;
    std::vector<Slab> slabs_;
    /// The target of the corrections, and their statistics.
    Energy* energy_ = nullptr;
    double steepest_ = 0;
    double largest_part_ = 0;
    int n_corrections_ = 0;
};

}  // namespace pcvt::plane
