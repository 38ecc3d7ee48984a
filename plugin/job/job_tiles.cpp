#include "plugin/job/job_tiles.hpp"

#include "mesher/proof/generated_tile.hpp"

namespace pcvt {

BuiltTile proved_tile(const Job& job, const CvtResult& result, MeshKind kind) {
    BuiltTile built = build_tile(result.delaunay, {.kind = kind,
                                                   .outline = job.outline,
                                                   .short_edges = job.short_edges,
                                                   .grain_size = job.grain_size,
                                                   .grain_per_edge = job.grain_per_edge,
                                                   .order = job.order,
                                                   .columns = job.columns,
                                                   .rows = job.rows,
                                                   .origin = job.origin,
                                                   .finds_origin = job.finds_origin});
    verify_generated_tile(built.tile);
    return built;
}

}  // namespace pcvt
