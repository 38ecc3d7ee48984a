#pragma once

#include "mesher/energy/triangle_terms.hpp"

namespace pcvt::testing {

/// The reference for triangle_terms: the contribution of a triangle by integrals over its six
/// right-angled parts, computed in fifty digits and rounded once.
struct WideTerms {
    double value = 0;
    std::array<Vec2, 3> gradient;
    std::array<double, 3> mass;
    /// The scales of rounding: sums of absolute values, computed as if no angle were a right angle.
    double value_size = 0;
    double gradient_size = 0;
    double mass_size = 0;
};

/// @param p, q  as for triangle_terms.
WideTerms wide_terms(const Vec2& p, const Vec2& q, const ReducedFrame& frame);

}  // namespace pcvt::testing
