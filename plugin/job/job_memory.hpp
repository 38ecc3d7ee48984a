#pragma once

#include <string>
#include <vector>

#include "plugin/job/job_files.hpp"

namespace pcvt {

/// The memory of the command with its libraries, and of one thread more, in bytes.
inline constexpr double kCommandBytes = 14e6;
inline constexpr double kThreadBytes = 1e6;

/// The memory that a run takes at its peak, in bytes: from the tables of bytes a site in
/// job_memory.cpp, which are measured. Between the peak and 1.5 times the peak.
///
/// Example usage:
///
///     check_job(job);
///     const double bytes = estimated_memory(job, plan_files(job));
double estimated_memory(const Job& job, const std::vector<JobFile>& files);

/// Refuses what takes more memory than is available. An estimate may be a quarter too high.
/// @param what    the subject and the verb of the message: "the run takes".
/// @param remedy  the end of the message.
/// @throws LimitExceeded with both amounts.
void require_available(const std::string& what, double estimate, const char* remedy);

inline constexpr const char* kFewerOutputs = "take fewer sites, or fewer outputs at a time";

/// Refuses a job that cannot fit into the memory that is available.
/// @throws LimitExceeded with both amounts.
void require_memory(const Job& job, const std::vector<JobFile>& files);

/// Refuses files of sites that are in memory already where they cannot fit.
/// @throws LimitExceeded with both amounts.
void require_memory_to_write(const Job& job, const std::vector<JobFile>& files);

/// Refuses a mesh of sites that are in memory already where it cannot fit: a tile of this kind,
/// with the outline, the copies and the grains of the job.
/// @throws LimitExceeded with both amounts.
void require_memory_for_mesh(const Job& job, plane::MeshKind kind);

/// An amount of memory in words: "18.3 GB", or "18.3 MB" below 0.1 GB.
std::string memory_text(double bytes);

}  // namespace pcvt
