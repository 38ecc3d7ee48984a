#include "plugin/job/job_tiles.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesher/grains/grains.hpp"
#include "mesher/mesh/box_origin.hpp"
#include "mesher/mesh/box_outline.hpp"
#include "mesher/mesh/outline.hpp"
#include "mesher/mesh/short_edges.hpp"
#include "mesher/mesh/valence.hpp"
#include "mesher/mesh/voronoi.hpp"
#include "plugin/job/job_proof.hpp"

namespace pcvt {
namespace {

/// The usual edge of a grain's triangle, in units of h.
constexpr double kUsualGrainSize = 1.0 / 3;

/// Faces and where each of them stands.
struct LaidOut {
    PeriodicMesh mesh;
    std::vector<Offset> placement;
};

LaidOut lay_out(const Job& job, PeriodicMesh mesh, double h, TileFigures& figures) {
    if (job.outline == Outline::kWhole) {
        std::vector<Offset> placement = whole_outline(mesh, job.origin);
        return {std::move(mesh), std::move(placement)};
    }
    const double snap = figures.kind == MeshKind::kGrains ? kGrainSnap * h : 0;
    figures.box_origin = job.finds_origin ? find_box_origin(mesh) : job.origin;
    BoxCut box = cut_along_box(mesh, *figures.box_origin, snap);
    figures.box_shortest_edge = box.shortest_edge / h;
    std::vector<Offset> placement(static_cast<std::size_t>(box.pieces.n_faces()));
    return {std::move(box.pieces), std::move(placement)};
}

LaidOut mesh_cells(const Job& job, const LaidOut& cells, double h, TileFigures& figures) {
    const double size = job.grain_size > 0 ? job.grain_size : kUsualGrainSize * h;
    Grains grains = job.grain_per_edge > 0 ? mesh_grains_per_edge(cells.mesh, job.grain_per_edge)
                                           : mesh_grains(cells.mesh, size);
    figures.grains = {grains.triangles.n_faces(), grains.smallest_angle, {}};
    for (const NamedCorner& corner : grains.named_corners) {
        const int f = cells.mesh.corner_face[corner.corner];
        const Vec2 p =
            cells.mesh.point(corner.corner) + cells.mesh.lattice.translation(cells.placement[f]);
        figures.grains->sharp_corners.push_back({cells.mesh.site[f], p, corner.angle});
    }
    std::vector<Offset> placement;
    for (const int f : grains.cell) placement.push_back(cells.placement[f]);
    return {std::move(grains.triangles), std::move(placement)};
}

PeriodicMesh without_shortest(PeriodicMesh cells, double shortest) {
    // What a cell's sides are is told by the cell as it was.
    cells.whole_sides = cell_sides(cells);
    return without_short_edges(cells, shortest);
}

}  // namespace

ProvedTile build_tile(const Job& job, const CvtResult& result, MeshKind kind) {
    const double h = result.delaunay.sites().spacing();
    const bool grains = kind == MeshKind::kGrains;
    const MeshKind source = grains ? MeshKind::kVoronoi : kind;
    PeriodicMesh mesh = repeated(periodic_mesh(result.delaunay, source), job.columns, job.rows);
    if (grains) {
        mesh = without_shortest(std::move(mesh), std::max(kShortGrainEdge, job.short_edges) * h);
    } else if (kind == MeshKind::kVoronoi && job.short_edges > 0) {
        mesh = without_short_edges(mesh, job.short_edges * h);
    }
    TileFigures figures{kind, 0, 0, {}, {}, {}};
    LaidOut laid_out = lay_out(job, std::move(mesh), h, figures);
    if (grains) laid_out = mesh_cells(job, laid_out, h, figures);
    OpenMeshTile tile = make_tile(laid_out.mesh, laid_out.placement);
    if (grains) std::get<TriangleTile>(tile).order = job.order;
    Tile flat = flatten(tile);
    const TileProof proof = verify_generated_tile(flat);
    figures.n_boundary_edges = proof.n_boundary_edges;
    figures.n_edge_pairs = static_cast<int>(proof.edge_pairs.size());
    return {std::move(tile), std::move(flat), std::move(figures)};
}

}  // namespace pcvt
