#pragma once

#include "mesher/energy/triangle_terms.hpp"

namespace pcvt::testing {

/// The terms' twin: what a triangle adds, by integrals over its six right-angled parts, in fifty
/// digits and rounded once.
struct WideTerms {
    double value = 0;
    std::array<Vec2, 3> gradient;
    std::array<double, 3> mass;
    /// What rounding is relative to: sums of absolute values, taken as if no angle were right.
    double value_size = 0;
    double gradient_size = 0;
    double mass_size = 0;
};

/// @param p, q  as of triangle_terms.
WideTerms wide_terms(const Vec2& p, const Vec2& q, const ReducedFrame& frame);

}  // namespace pcvt::testing
