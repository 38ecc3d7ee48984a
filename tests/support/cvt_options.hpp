#pragma once

#include <array>
#include <cstdint>

#include "mesher/plane/cvt/coarse_start.hpp"
#include "mesher/plane/cvt/cvt.hpp"

namespace pcvt::testing {

inline constexpr std::array kAllWalls{Walls::kX, Walls::kY, Walls::kXY};

/// The usual options with another tolerance.
inline plane::CvtOptions to_tolerance(double tolerance) {
    plane::CvtOptions options;
    options.run.tolerance = tolerance;
    return options;
}

/// A coarse start of constant density from a seed.
inline plane::CoarseStartOptions seeded(std::uint64_t seed, int n_threads = 1) {
    return {{.seed = seed, .n_threads = n_threads}};
}

}  // namespace pcvt::testing
