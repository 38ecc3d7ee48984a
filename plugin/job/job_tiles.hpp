#pragma once

#include "mesher/tile/build_tile.hpp"
#include "plugin/job/job.hpp"

namespace pcvt {

/// Builds one mesh of a job and proves it.
/// @throws LimitExceeded  grains too fine, or a piece of a cell too thin for them.
/// @throws InternalError  the tile breaks its laws: a fault of pcvt.
BuiltTile proved_tile(const Job& job, const CvtResult& result, MeshKind kind);

}  // namespace pcvt
