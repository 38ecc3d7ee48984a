#pragma once

#include <vector>

#include "plugin/job/space_files.hpp"

namespace pcvt {

/// The memory that a run takes at its peak, in bytes: from the bytes a site in space_memory.cpp,
/// which are measured. Between the peak and 1.5 times the peak from 10,000 sites on.
///
/// Example usage:
///     const double bytes = memory_in_space(job, plan_files(job));
double memory_in_space(const Job& job, const std::vector<JobFile>& files);

/// The memory that cells, or files with their cells, take beside a SpaceComputation that is in
/// memory: the same figures less that of the sites, their triangulation and the command.
/// @param job  its short edges and its form of files.
double memory_of_cells(const Job& job, int n_sites);
double memory_to_write(const Job& job, int n_sites, const std::vector<JobFile>& files);

}  // namespace pcvt
