#pragma once

#include <algorithm>
#include <array>

#include "mesher/plane/delaunay/torus_triangulation.hpp"
#include "mesher/plane/geometry/reduced_frame.hpp"

namespace pcvt::plane {

/// The contribution of one triangle to the energy, its gradient and the masses (energy.hpp).
struct TriangleTerms {
    double value = 0;
    /// The gradient at corners 0, 1, 2.
    std::array<Vec2, 3> gradient{Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
    std::array<double, 3> mass{};
    /// The largest |cotangent|.
    double steepest = 0;
    /// The largest absolute value among the sides' parts of the value.
    double largest_part = 0;
};

/// Computes the terms accurately for thin triangles too: the rounding stays near 1e-16 of the
/// largest term where two corners almost coincide.
/// @param p, q  corners 1 and 2 relative to corner 0, coordinates of the reduced basis, exact.
TriangleTerms triangle_terms(const Vec2& p, const Vec2& q, const ReducedFrame& frame);

/// The same terms for many triangles at once, without branches.
struct TriangleBlock {
    static constexpr int kSize = 64;
    using Row = std::array<double, kSize>;

    /// Input: corners 1 and 2 relative to corner 0.
    Row pu, pv, qu, qv;
    /// Output: the gradient at corners 0, 1, 2, their masses, the value.
    Row gx0, gy0, gx1, gy1, gx2, gy2, m0, m1, m2, value;
    /// The cosines at corners 0, 1, 2, each scaled by the lengths of its two sides.
    Row cosine0, cosine1, cosine2;
    /// Positive where the triangle is certainly counter-clockwise and not thin.
    Row thick;
    /// Positive where all angles are certainly acute.
    Row acute;

    /// Fills in the corners of the n triangles from `first` on.
    /// @param coordinates  2 x n, reduced basis.
    void gather(const TorusTriangulation& triangulation, const Points& coordinates, int first,
                int n);
    void compute(const ReducedFrame& frame);
    /// The halfedge opposite to the largest angle of triangle t, the k-th of the block.
    int opposite_to_largest_angle(int t, int k) const {
        const std::array<double, 3> cosine{cosine0[k], cosine1[k], cosine2[k]};
        const auto corner = std::min_element(cosine.begin(), cosine.end()) - cosine.begin();
        return TorusTriangulation::next(3 * t + static_cast<int>(corner));
    }
};

}  // namespace pcvt::plane
