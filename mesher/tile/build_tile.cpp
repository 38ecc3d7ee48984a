#include "mesher/tile/build_tile.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesher/grains/grains.hpp"
#include "mesher/lattice/domain.hpp"
#include "mesher/mesh/box_origin.hpp"
#include "mesher/mesh/box_outline.hpp"
#include "mesher/mesh/short_edges.hpp"
#include "mesher/mesh/valence.hpp"
#include "mesher/mesh/voronoi.hpp"
#include "mesher/tile/tile_builder.hpp"

namespace pcvt {
namespace {

/// The usual edge of a grain's triangle, in units of h.
constexpr double kUsualGrainSize = 1.0 / 3;

/// The shares of the time at which the meshing of grains begins and ends; without them, the cells
/// are laid out at the one and the tile is made from the other on.
constexpr double kGrainsBegin = 0.2;
constexpr double kGrainsEnd = 0.8;

void report(const TileOptions& options, double share) {
    if (options.progress) options.progress(share);
}

/// Faces with the offset of each.
struct LaidOut {
    PeriodicMesh mesh;
    std::vector<Offset> placement;
    /// Of grains, as Tile::grain_site_points.
    std::vector<Vec2> grain_site_points = {};
};

LaidOut lay_out(const TileOptions& options, PeriodicMesh mesh, double h, TileFigures& figures) {
    if (options.outline == Outline::kWhole) {
        const Domain domain(mesh.lattice, options.origin);
        figures.domain_corner = domain.corner();
        figures.opposite_corner = domain.opposite_corner();
        std::vector<Offset> placement = whole_outline(mesh, options.origin);
        return {std::move(mesh), std::move(placement)};
    }
    const double snap = figures.kind == MeshKind::kGrains ? kGrainSnap * h : 0;
    figures.domain_corner = options.finds_origin ? find_box_origin(mesh) : options.origin;
    figures.opposite_corner = figures.domain_corner + mesh.lattice.a() + mesh.lattice.b();
    BoxCut box = cut_along_box(mesh, figures.domain_corner, snap);
    figures.box_shortest_edge = box.shortest_edge / h;
    std::vector<Offset> placement(static_cast<std::size_t>(box.pieces.n_faces()));
    return {std::move(box.pieces), std::move(placement)};
}

LaidOut mesh_cells(const TileOptions& options, const LaidOut& cells, double h,
                   TileFigures& figures) {
    const double size = options.grain_size > 0 ? options.grain_size : kUsualGrainSize * h;
    const auto progress = [&options](double share) {
        report(options, kGrainsBegin + (kGrainsEnd - kGrainsBegin) * share);
    };
    Grains grains = options.grain_per_edge > 0
                        ? mesh_grains_per_edge(cells.mesh, options.grain_per_edge, progress)
                        : mesh_grains(cells.mesh, size, progress);
    figures.grains = {grains.triangles.n_faces(), grains.smallest_angle, {}};
    for (const NamedCorner& corner : grains.named_corners) {
        const int f = cells.mesh.corner_face[corner.corner];
        const Vec2 p =
            cells.mesh.point(corner.corner) + cells.mesh.lattice.translation(cells.placement[f]);
        figures.grains->sharp_corners.push_back({cells.mesh.site[f], p, corner.angle});
    }
    LaidOut laid_out{std::move(grains.triangles), {}};
    for (const int f : grains.cell) {
        laid_out.placement.push_back(cells.placement[f]);
        laid_out.grain_site_points.push_back(cells.mesh.site_points[f] +
                                             cells.mesh.lattice.translation(cells.placement[f]));
    }
    return laid_out;
}

PeriodicMesh without_shortest(PeriodicMesh cells, double shortest) {
    // Cells keep the number of sides that they had before.
    cells.whole_sides = cell_sides(cells);
    return without_short_edges(cells, shortest);
}

/// The cells or triangles of columns x rows domains, without short edges.
PeriodicMesh torus_mesh(const PeriodicDelaunay& delaunay, const TileOptions& options, double h) {
    const bool grains = options.kind == MeshKind::kGrains;
    const MeshKind source = grains ? MeshKind::kVoronoi : options.kind;
    PeriodicMesh domain = periodic_mesh(delaunay, source);
    if (const auto& elongation = options.elongation) {
        domain = from_round(std::move(domain), elongation->metric, elongation->lattice);
    }
    PeriodicMesh mesh = repeated(std::move(domain), options.columns, options.rows);
    if (grains) {
        return without_shortest(std::move(mesh),
                                std::max(kShortGrainEdge, options.short_edges) * h);
    }
    if (options.kind == MeshKind::kVoronoi && options.short_edges > 0) {
        return without_short_edges(mesh, options.short_edges * h);
    }
    return mesh;
}

}  // namespace

BuiltTile build_tile(const PeriodicDelaunay& delaunay, const TileOptions& options) {
    const double h = delaunay.sites().spacing();
    TileFigures figures{.kind = options.kind};
    PeriodicMesh mesh = torus_mesh(delaunay, options, h);
    report(options, kGrainsBegin);
    LaidOut laid_out = lay_out(options, std::move(mesh), h, figures);
    if (options.kind == MeshKind::kGrains) laid_out = mesh_cells(options, laid_out, h, figures);
    report(options, kGrainsEnd);
    Tile tile = make_tile(laid_out.mesh, laid_out.placement);
    if (options.elongation) tile.metric = options.elongation->metric;
    tile.site_weights.assign(delaunay.weights().begin(), delaunay.weights().end());
    tile.grain_site_points = std::move(laid_out.grain_site_points);
    tile.columns = options.columns;
    tile.rows = options.rows;
    tile.short_edges = options.short_edges;
    if (options.kind == MeshKind::kGrains) tile.order = options.order;
    figures.n_edge_pairs = static_cast<int>(tile.edge_pairs.size());
    figures.n_boundary_edges = 2 * figures.n_edge_pairs;
    return {std::move(tile), std::move(figures)};
}

}  // namespace pcvt
