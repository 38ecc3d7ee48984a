#pragma once

#include <string>

#include "mesher/plane/tile/build_tile.hpp"
#include "plugin/job/job.hpp"
#include "plugin/job/job_files.hpp"

namespace pcvt {

/// Whether a job needs its tiles: an output holds them, or the job has figures of its own for them,
/// which are those of grains and of the box outline.
bool needs_tiles(const Job& job, const std::vector<JobFile>& files);

/// The message for measured grains whose cells break a law by rounding: their sites may lie much
/// nearer to each other, or farther from the cells, than the cells are wide.
std::string unheld_grains(const std::string& fault);

/// Builds the meshes of a job and then proves them; tile k belongs to job.meshes[k].
/// @throws LimitExceeded  grains too fine, or a piece of a cell too thin for them.
/// @throws InvalidInput   measured grains whose cells doubles do not hold.
/// @throws InternalError  a tile breaks its laws: a fault of pcvt.
std::vector<plane::BuiltTile> proved_tiles(const Job& job, const plane::Tessellation& cells,
                                           JobMonitor& monitor);

}  // namespace pcvt
