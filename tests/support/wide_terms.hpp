#pragma once

#include "mesher/plane/energy/triangle_terms.hpp"

namespace pcvt::testing {

/// The reference for triangle_terms: the contribution of a triangle by integrals over its six
/// right-angled parts, computed in fifty digits and rounded once.
struct WideTerms {
    double value = 0;
    std::array<plane::Vec2, 3> gradient;
    std::array<double, 3> mass;
    /// The scales of rounding: sums of absolute values, computed as if no angle were a right angle.
    double value_size = 0;
    double gradient_size = 0;
    double mass_size = 0;
};

/// @param p, q  as for triangle_terms.
WideTerms wide_terms(const plane::Vec2& p, const plane::Vec2& q, const plane::ReducedFrame& frame);

}  // namespace pcvt::testing
