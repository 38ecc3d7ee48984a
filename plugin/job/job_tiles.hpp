#pragma once

#include "mesher/plane/tile/build_tile.hpp"
#include "plugin/job/job.hpp"
#include "plugin/job/job_files.hpp"

namespace pcvt {

/// Whether a job needs its tiles: an output holds them, or the job has figures of its own for them,
/// which are those of grains and of the box outline.
bool needs_tiles(const Job& job, const std::vector<JobFile>& files);

/// Builds the meshes of a job and then proves them; tile k belongs to job.meshes[k].
/// @throws LimitExceeded  grains too fine, or a piece of a cell too thin for them.
/// @throws InternalError  a tile breaks its laws: a fault of pcvt.
std::vector<plane::BuiltTile> proved_tiles(const Job& job, const plane::Tessellation& cells,
                                           JobMonitor& monitor);

}  // namespace pcvt
