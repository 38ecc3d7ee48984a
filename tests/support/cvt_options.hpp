#pragma once

#include <array>
#include <cstdint>

#include "mesher/cvt/coarse_start.hpp"
#include "mesher/cvt/cvt.hpp"

namespace pcvt::testing {

inline constexpr std::array kAllWalls{Walls::kX, Walls::kY, Walls::kXY};

/// The usual options with another tolerance.
inline CvtOptions to_tolerance(double tolerance) {
    CvtOptions options;
    options.tolerance = tolerance;
    return options;
}

/// A coarse start of constant density from a seed.
inline CoarseStartOptions seeded(std::uint64_t seed, int n_threads = 1) {
    return {.seed = seed, .n_threads = n_threads, .density = {}, .progress = {}};
}

}  // namespace pcvt::testing
