#pragma once

#include <array>

#include "mesher/plane/cvt/cvt.hpp"

namespace pcvt::testing {

inline constexpr std::array kAllWalls{Walls::kX, Walls::kY, Walls::kXY};

/// The usual options with another tolerance.
inline plane::CvtOptions to_tolerance(double tolerance) {
    plane::CvtOptions options;
    options.run.tolerance = tolerance;
    return options;
}

}  // namespace pcvt::testing
