#include "plugin/job/space_grains.hpp"

#include <algorithm>
#include <utility>

#include "mesher/space/box/box_cells.hpp"
#include "mesher/space/box/box_sides.hpp"
#include "mesher/space/grains/grains.hpp"
#include "mesher/space/mesh/short_edges.hpp"
#include "plugin/job/space_box.hpp"

namespace pcvt {
namespace {

/// Edges below this part of h are removed from Voronoi cells: nobody sees them, and each would take
/// layers of ever smaller tetrahedra.
constexpr double kShortGrainEdgeInSpace = 1e-3;
/// Vertices within this part of the shortest edges that remain are snapped to a side of the box, as
/// far as kSnappedVertices allows; none where no edges are removed.
constexpr double kSnappedOverShort = 0.1;

SpaceGrainFigures figures_of(const space::Grains& grains) {
    const space::TetrahedralMesh& mesh = grains.mesh.tetrahedra;
    SpaceGrainFigures figures{.n_tetrahedra = mesh.n_tetrahedra(),
                              .n_points = mesh.n_points(),
                              .n_sharp = static_cast<int>(grains.sharp_features.size())};
    if (grains.angles.largest > 0) {
        figures.smallest_angle = grains.angles.smallest;
        figures.largest_angle = grains.angles.largest;
    }
    if (figures.n_sharp == 0) return figures;
    figures.smallest_sharp_angle = grains.angles_at_features.smallest;
    figures.sharpest = grains.sharp_features.front().angle;
    for (const space::SharpFeature& feature : grains.sharp_features) {
        figures.sharpest = std::min(figures.sharpest, feature.angle);
    }
    return figures;
}

}  // namespace

SpaceGrains build_space_grains(const Job& job, const space::Tessellation& cells,
                               JobMonitor& monitor) {
    monitor.begin(Phase::kBuilding, "filling the cells with tetrahedra");
    // Power cells keep their volumes unless the user asks otherwise.
    const double shortest = cells.delaunay.weights.size() > 0
                                ? job.tile.short_edges
                                : std::max(job.tile.short_edges, kShortGrainEdgeInSpace);
    const space::CellComplex complex = outlined_cells(
        job, cells, without_short_edges(cells.complex(), shortest, space::ShrinkRule::kWideCorners),
        std::min(space::kSnappedVertices, kSnappedOverShort * shortest));
    const space::Vec3 origin = tile_origin(job, cells);
    Workers workers(job.run.n_threads);
    space::Grains grains = mesh_grains(
        cells.sites(), complex,
        {.size = job.tile.grain_size, .progress = [&](double part) { monitor.advance(part); }},
        workers, origin);
    if (!complex.piece_cell.empty()) put_on_sides(origin, grains.mesh.tetrahedra);
    const SpaceGrainFigures figures = figures_of(grains);
    return {.tetrahedra = std::move(grains.mesh.tetrahedra), .figures = figures};
}

}  // namespace pcvt
