#pragma once

#include "mesher/tile/build_tile.hpp"
#include "plugin/job/job.hpp"

namespace pcvt {

/// Builds the meshes of a job and then proves them; tile k belongs to job.meshes[k].
/// @throws LimitExceeded  grains too fine, or a piece of a cell too thin for them.
/// @throws InternalError  a tile breaks its laws: a fault of pcvt.
std::vector<BuiltTile> proved_tiles(const Job& job, const CvtResult& result, JobMonitor& monitor);

}  // namespace pcvt
