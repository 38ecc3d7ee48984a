#pragma once

#include "plugin/job/job.hpp"
#include "plugin/job/job_progress.hpp"
#include "plugin/job/run_summary.hpp"

namespace pcvt {

/// The sites with which the optimisation of a job in space begins, as job_start() in the plane.
/// @param figures  of the pattern, which a start at a lattice fills in.
/// @throws Cancelled
space::Points space_start_points(const Job& job, JobMonitor& monitor, StartFigures& figures);

}  // namespace pcvt
