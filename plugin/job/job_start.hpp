#pragma once

#include "plugin/job/job.hpp"

namespace pcvt {

/// Where the sites of a job begin, and what is known of that place.
struct JobStart {
    /// 2 x n, length units.
    Points points;
    /// For CvtOptions.
    double precondition_below = CvtOptions().precondition_below;
    /// The best lattice for n, where the start looked for it.
    std::optional<PatternOutcome> pattern;
    /// Of the global search: how it found the place, and what it spent.
    std::string found;
    int evaluations = 0;
    bool cancelled = false;
};

/// Sites that the user gave keep their numbers; all others are numbered column by column.
/// @param callback  as run_job's; called by the coarse start and the global search.
JobStart job_start(const Job& job, const JobCallback& callback);

/// The start as contract words: "file", "random", "coarse", "lattice", "best".
const char* start_name(const Job& job);

}  // namespace pcvt
