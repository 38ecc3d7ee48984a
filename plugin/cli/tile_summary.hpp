#pragma once

#include <string>

#include "plugin/job/run_job.hpp"

namespace pcvt::cli {

/// The lines of the tiles of a run in the plane, and of the wedges above them.
std::string tile_lines(const Job& job, const RunSummary& summary);

}  // namespace pcvt::cli
