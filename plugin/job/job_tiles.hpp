#pragma once

#include "plugin/job/job.hpp"

namespace pcvt {

/// Repeats the tessellation, takes out short edges where grains are asked for, lays it out in the
/// outline of the job, meshes the grains, and proves the tile.
/// @throws LimitExceeded  grains too fine, or a piece of a cell too thin for them.
/// @throws InternalError  the tile breaks its laws: a fault of pcvt.
ProvedTile build_tile(const Job& job, const CvtResult& result, MeshKind kind);

}  // namespace pcvt
