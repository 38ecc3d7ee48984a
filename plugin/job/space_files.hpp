#pragma once

#include <string>

#include "plugin/job/job_files.hpp"

namespace pcvt {

/// The file of an output of a job in space.
/// @throws InvalidInput for a format that holds nothing of space, and for one that holds no
///         tetrahedra, or no removed edges, where the job has them.
JobFile space_file(const Job& job, const Format& format, const std::string& path);

}  // namespace pcvt
