#pragma once

#include "mesher/tile.hpp"
#include "plugin/job.hpp"

namespace pcvt {

/// One mesh of a job, laid out and proved.
struct ProvedTile {
    AnyTile tile;
    TileFigures figures;
};

/// Repeats the tessellation, takes out short edges where grains are asked for, lays it out in the
/// outline of the job, meshes the grains, and proves the tile.
/// @throws LimitExceeded  grains too fine, or a piece of a cell too thin for them.
/// @throws InternalError  the tile breaks its laws: a fault of pcvt.
ProvedTile build_tile(const Job& job, const CvtResult& result, TileKind kind);

}  // namespace pcvt
