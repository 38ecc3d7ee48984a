#pragma once

#include <string>
#include <vector>

#include "plugin/job/job_files.hpp"

namespace pcvt {

/// Whether some mesh of the job has a property of the table of mesh kinds:
///   if (!has_mesh(job, &MeshKindRow::order_2)) throw InvalidInput("--order is for grains");
bool has_mesh(const Job& job, bool plane::MeshKindRow::*property);

/// The largest Job::short_edges of its dimension.
double longest_short_edge(const Job& job);

/// Requires that retries have an effect: drawn sites, and an output that can refuse their cells.
/// @throws InvalidInput if they have none.
void check_retries(const Job& job, const std::vector<JobFile>& files);

}  // namespace pcvt
