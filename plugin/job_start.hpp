#pragma once

#include "plugin/job.hpp"

namespace pcvt {

/// Where the sites of a job begin, and what is known of that place.
struct JobStart {
    /// 2 x n, length units.
    Points points;
    /// The best lattice for n, where the start looked for it.
    std::optional<PatternOutcome> pattern;
};

/// @throws InvalidInput for a start that is not available yet.
JobStart job_start(const Job& job);

/// The start as contract words: "file", "random", "coarse", "lattice", "best".
const char* start_name(const Job& job);

}  // namespace pcvt
