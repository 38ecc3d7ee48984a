#pragma once

#include <string>
#include <vector>

#include "plugin/job/job_files.hpp"

namespace pcvt {

/// The memory that a run takes at its peak, in bytes: from the bytes a site in space_memory.cpp,
/// which are measured. Between the peak and 1.5 times the peak from 10,000 sites on.
///
/// Example usage:
///     const double bytes = memory_in_space(job, plan_files(job));
double memory_in_space(const Job& job, const std::vector<JobFile>& files);

/// The memory that the cells, and files, of a job take beside its sites and their triangulation,
/// which are in memory.
double space_memory_to_write(const Job& job, const std::vector<JobFile>& files);

/// The subject and the verb of a message about the memory of a run: the tetrahedra where there are
/// many, else the run.
std::string space_run_takes(const Job& job);

}  // namespace pcvt
