#include "mesher/plane/tile/build_tile.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "mesher/plane/grains/grains.hpp"
#include "mesher/plane/mesh/torus_mesh.hpp"
#include "mesher/plane/mesh/walled_mesh.hpp"
#include "mesher/plane/tile/tile_builder.hpp"
#include "mesher/plane/tile/tile_holes.hpp"

namespace pcvt::plane {
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
    /// Two opposite corners of the domain round which the faces lie.
    Vec2 domain_corner;
    Vec2 opposite_corner;
    /// The sites of the cells of grains, as Tile::grain_site_points.
    std::vector<Vec2> grain_site_points = {};
    std::optional<GrainFigures> grains = {};
    /// With walls: the offset at which each face lies between the walls; no offset for the mirror
    /// images, whose placement and points mean nothing.
    std::vector<std::optional<Offset>> between_walls = {};

    bool is_placed(int f) const { return between_walls.empty() || between_walls[f].has_value(); }
};

/// The domain of the tile: columns x rows domains between walls.
WalledDomain walled_domain(const TileOptions& options) {
    return options.walled->repeated(options.repeat.columns, options.repeat.rows);
}

/// The entries of the faces between walls.
std::vector<Offset> placed_only(const LaidOut& laid_out) {
    std::vector<Offset> placement;
    for (int f = 0; f < laid_out.mesh.n_faces(); ++f) {
        if (laid_out.is_placed(f)) placement.push_back(laid_out.placement[f]);
    }
    return placement;
}

LaidOut lay_out_between_walls(const TileOptions& options, TorusMesh torus) {
    const WalledDomain domain = walled_domain(options);
    LaidOut laid_out{std::move(torus.mesh), {}, torus.corner, torus.opposite_corner};
    laid_out.between_walls = places_between_walls(laid_out.mesh, domain);
    move_onto_walls(laid_out.mesh, laid_out.between_walls, domain);
    laid_out.placement.resize(laid_out.between_walls.size());
    if (torus.is_cut()) return laid_out;
    const PeriodicMesh between = mesh_between_walls(laid_out.mesh, laid_out.between_walls, domain);
    const std::vector<Offset> placement = whole_outline(between, options.origin);
    auto next = placement.begin();
    for (std::size_t f = 0; f < laid_out.placement.size(); ++f) {
        if (laid_out.between_walls[f]) laid_out.placement[f] = *next++;
    }
    return laid_out;
}

LaidOut lay_out(const TileOptions& options, TorusMesh torus) {
    if (options.walled) return lay_out_between_walls(options, std::move(torus));
    PeriodicMesh& mesh = torus.mesh;
    std::vector<Offset> placement = torus.is_cut()
                                        ? std::vector<Offset>(std::size_t(mesh.n_faces()))
                                        : whole_outline(mesh, options.origin);
    return {std::move(mesh), std::move(placement), torus.corner, torus.opposite_corner};
}

/// The tile of faces that are laid out.
Tile tile_of(const TileOptions& options, const LaidOut& laid_out) {
    if (!options.walled) return make_tile(laid_out.mesh, laid_out.placement);
    const WalledDomain domain = walled_domain(options);
    const PeriodicMesh between = mesh_between_walls(laid_out.mesh, laid_out.between_walls, domain);
    return make_walled_tile(between, placed_only(laid_out), domain);
}

/// The translation of a face that has a place.
Vec2 translation_of(const LaidOut& laid_out, int f) {
    const Offset between = laid_out.between_walls.empty() ? Offset{} : *laid_out.between_walls[f];
    return laid_out.mesh.lattice.translation(laid_out.placement[f] + between);
}

/// The cells, meshed by triangles.
Grains grains_of(const TileOptions& options, const LaidOut& cells, double h) {
    const double size = options.grain_size > 0 ? options.grain_size : kUsualGrainSize * h;
    const auto progress = [&options](double share) {
        report(options, kGrainsBegin + (kGrainsEnd - kGrainsBegin) * share);
    };
    try {
        return options.grain_per_edge > 0
                   ? mesh_grains_per_edge(cells.mesh, options.grain_per_edge, progress)
                   : mesh_grains(cells.mesh, size, progress);
    } catch (const ThinCell& thin) {
        if (options.outline == Outline::kWhole) {
            throw ThinCell(thin.site(),
                           std::string(thin.what()) +
                               "; take more sites, optimise them, or shorten the longer period");
        }
        throw ThinCell(thin.site(), "a piece of " + std::string(thin.what()) +
                                        "; give another origin, or use the whole outline");
    }
}

LaidOut mesh_cells(const TileOptions& options, const LaidOut& cells, double h) {
    Grains grains = grains_of(options, cells, h);
    GrainFigures figures{0, grains.smallest_angle, {}};
    for (const NamedCorner& corner : grains.named_corners) {
        const int f = cells.mesh.corner_face[corner.corner];
        if (!cells.is_placed(f)) continue;
        const Vec2 p = cells.mesh.point(corner.corner) + translation_of(cells, f);
        figures.sharp_corners.push_back({cells.mesh.site[f], p, corner.angle});
    }
    LaidOut laid_out{std::move(grains.triangles), {}, cells.domain_corner, cells.opposite_corner};
    for (const int f : grains.cell) {
        laid_out.placement.push_back(cells.placement[f]);
        if (!cells.between_walls.empty()) {
            laid_out.between_walls.push_back(cells.between_walls[f]);
        }
        if (!cells.is_placed(f)) continue;
        ++figures.n_triangles;
        laid_out.grain_site_points.push_back(cells.mesh.site_points[f] + translation_of(cells, f));
    }
    laid_out.grains = std::move(figures);
    return laid_out;
}

}  // namespace

BuiltTile build_tile(const PeriodicDelaunay& delaunay, const TileOptions& options) {
    return build_tile(domain_mesh(delaunay, options), delaunay, options);
}

BuiltTile build_tile(PeriodicMesh domain, const PeriodicDelaunay& delaunay,
                     const TileOptions& options) {
    TorusMesh torus = torus_mesh(std::move(domain), delaunay, options);
    const Eigen::VectorXd weights = std::move(torus.weights);
    const std::optional<double> area_error = torus.area_error;
    const std::optional<double> shortest_edge = torus.box_shortest_edge;
    report(options, kGrainsBegin);
    LaidOut laid_out = lay_out(options, std::move(torus));
    if (options.kind == MeshKind::kGrains) {
        laid_out = mesh_cells(options, laid_out, delaunay.sites().spacing());
    }
    report(options, kGrainsEnd);
    Tile tile = tile_of(options, laid_out);
    if (options.elongation) tile.metric = options.elongation->metric;
    tile.site_weights.assign(weights.begin(), weights.end());
    tile.grain_site_points = std::move(laid_out.grain_site_points);
    tile.columns = options.repeat.columns;
    tile.rows = options.repeat.rows;
    tile.short_edges = options.short_edges;
    if (options.kind == MeshKind::kGrains) tile.order = options.order;
    tile = with_holes(std::move(tile), options.holes);
    const auto n_pairs = static_cast<int>(tile.edge_pairs.size());
    const auto n_wall_edges = static_cast<int>(tile.wall_edges.size());
    return {std::move(tile),
            {.kind = options.kind,
             .n_boundary_edges = 2 * n_pairs + n_wall_edges,
             .n_edge_pairs = n_pairs,
             .n_wall_edges = n_wall_edges,
             .domain_corner = laid_out.domain_corner,
             .opposite_corner = laid_out.opposite_corner,
             .box_shortest_edge = shortest_edge,
             .grains = std::move(laid_out.grains),
             .area_error = area_error}};
}

}  // namespace pcvt::plane
