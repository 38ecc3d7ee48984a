#include "mesher/plane/tile/build_tile.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "mesher/plane/geometry/domain.hpp"
#include "mesher/plane/grains/grains.hpp"
#include "mesher/plane/mesh/area_fit.hpp"
#include "mesher/plane/mesh/box_origin.hpp"
#include "mesher/plane/mesh/box_outline.hpp"
#include "mesher/plane/mesh/short_edges.hpp"
#include "mesher/plane/mesh/valence.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/tile/tile_builder.hpp"

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
    /// Of grains, as Tile::grain_site_points.
    std::vector<Vec2> grain_site_points = {};
    /// With walls: the offset at which each face lies between the walls; no offset for the mirror
    /// images, whose placement and points mean nothing.
    std::vector<std::optional<Offset>> between_walls = {};

    bool is_placed(int f) const { return between_walls.empty() || between_walls[f].has_value(); }
};

/// How far the outline moves vertices, length units.
double snap_distance(const TileOptions& options, double h) {
    return options.kind == MeshKind::kGrains ? kGrainSnap * h : 0;
}

/// The vertices on interfaces, which stay where they are; empty without tags.
std::vector<bool> still_vertices(const TileOptions& options, const PeriodicMesh& cells) {
    if (options.site_tags.empty()) return {};
    std::vector<int> tags;
    for (const SiteId s : cells.site) tags.push_back(options.site_tags[s]);
    return interface_vertices(cells, tags);
}

/// The domain of the tile: columns x rows domains between walls.
WalledDomain walled_domain(const TileOptions& options) {
    return options.walled->repeated(options.columns, options.rows);
}

/// The entries of the faces between walls.
std::vector<Offset> placed_only(const LaidOut& laid_out) {
    std::vector<Offset> placement;
    for (int f = 0; f < laid_out.mesh.n_faces(); ++f) {
        if (laid_out.is_placed(f)) placement.push_back(laid_out.placement[f]);
    }
    return placement;
}

/// The box outline cuts the torus along the periodic direction only: across walls it runs through
/// the middle of the mirror images. `nullopt`: nothing is cut.
std::optional<BoxCut> box_between_walls(const TileOptions& options, const PeriodicMesh& mesh,
                                        const WalledDomain& domain, double h) {
    if (options.outline == Outline::kWhole || domain.walls == Walls::kXY) return std::nullopt;
    Vec2 corner = options.origin;
    const int axis = domain.walls == Walls::kX ? 0 : 1;
    corner[axis] = -side_length(domain.lattice, axis) / 2;
    return cut_along_box(mesh, corner, snap_distance(options, h),
                         {.still = still_vertices(options, mesh)});
}

LaidOut lay_out_between_walls(const TileOptions& options, PeriodicMesh mesh, double h,
                              TileFigures& figures) {
    const WalledDomain domain = walled_domain(options);
    figures.domain_corner = options.origin;
    figures.opposite_corner = options.origin + domain.lattice.a() + domain.lattice.b();
    std::optional<BoxCut> box = box_between_walls(options, mesh, domain, h);
    if (box) {
        figures.box_shortest_edge = box->shortest_edge / h;
        mesh = std::move(box->pieces);
    }
    LaidOut laid_out{std::move(mesh), {}};
    laid_out.between_walls = places_between_walls(laid_out.mesh, domain);
    move_onto_walls(laid_out.mesh, laid_out.between_walls, domain);
    laid_out.placement.resize(laid_out.between_walls.size());
    if (box) return laid_out;
    const PeriodicMesh between = mesh_between_walls(laid_out.mesh, laid_out.between_walls, domain);
    const std::vector<Offset> placement = whole_outline(between, options.origin);
    auto next = placement.begin();
    for (std::size_t f = 0; f < laid_out.placement.size(); ++f) {
        if (laid_out.between_walls[f]) laid_out.placement[f] = *next++;
    }
    return laid_out;
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
            throw LimitExceeded(std::string(thin.what()) +
                                "; take more sites, optimise them, or shorten the longer period");
        }
        throw LimitExceeded("a piece of " + std::string(thin.what()) +
                            "; give another origin, or use the whole outline");
    }
}

LaidOut mesh_cells(const TileOptions& options, const LaidOut& cells, double h,
                   TileFigures& figures) {
    Grains grains = grains_of(options, cells, h);
    figures.grains = {0, grains.smallest_angle, {}};
    for (const NamedCorner& corner : grains.named_corners) {
        const int f = cells.mesh.corner_face[corner.corner];
        if (!cells.is_placed(f)) continue;
        const Vec2 p = cells.mesh.point(corner.corner) + translation_of(cells, f);
        figures.grains->sharp_corners.push_back({cells.mesh.site[f], p, corner.angle});
    }
    LaidOut laid_out{std::move(grains.triangles), {}};
    for (const int f : grains.cell) {
        laid_out.placement.push_back(cells.placement[f]);
        if (!cells.between_walls.empty()) {
            laid_out.between_walls.push_back(cells.between_walls[f]);
        }
        if (!cells.is_placed(f)) continue;
        ++figures.grains->n_triangles;
        laid_out.grain_site_points.push_back(cells.mesh.site_points[f] + translation_of(cells, f));
    }
    return laid_out;
}

/// The length below which edges are removed, in units of h; 0: none.
double shortest_edge(const TileOptions& options) {
    if (options.kind == MeshKind::kDelaunay) return 0;
    const bool grains = options.kind == MeshKind::kGrains;
    return grains ? std::max(kShortGrainEdge, options.short_edges) : options.short_edges;
}

PeriodicMesh without_shortest(PeriodicMesh cells, const TileOptions& options, double h) {
    const double shortest = shortest_edge(options);
    if (!(shortest > 0)) return cells;
    // Cells of grains keep the number of sides that they had before.
    if (options.kind == MeshKind::kGrains) cells.whole_sides = cell_sides(cells);
    return without_short_edges(cells, shortest * h, still_vertices(options, cells));
}

/// The cells of one domain, or the triangles of the torus.
PeriodicMesh domain_mesh(const PeriodicDelaunay& delaunay, const TileOptions& options) {
    if (options.kind != MeshKind::kDelaunay && options.walled) {
        return part_between_walls(cell_mesh(delaunay), *options.walled);
    }
    const bool grains = options.kind == MeshKind::kGrains;
    PeriodicMesh domain = periodic_mesh(delaunay, grains ? MeshKind::kVoronoi : options.kind);
    if (const auto& elongation = options.elongation) {
        domain = from_round(std::move(domain), elongation->metric, elongation->lattice);
    }
    return domain;
}

/// @param mesh  without short edges.
Vec2 corner_of_domain(const TileOptions& options, const PeriodicMesh& mesh) {
    const bool finds = options.outline == Outline::kBox && options.finds_origin;
    return finds ? find_box_origin(mesh) : options.origin;
}

/// The cells or triangles of columns x rows domains, without short edges.
struct TorusMesh {
    PeriodicMesh mesh{.lattice = Lattice::rectangle(1, 1), .kind = MeshKind::kVoronoi};
    /// The corner of the domain.
    Vec2 corner = Vec2::Zero();
    /// Empty without weights.
    Eigen::VectorXd weights = {};
    /// The cut of the mesh along the box, if it is made already.
    std::optional<BoxCut> cut = {};
};

TorusMesh torus_mesh(const TileOptions& options, PeriodicMesh domain, double h) {
    PeriodicMesh mesh =
        without_shortest(repeated(std::move(domain), options.columns, options.rows), options, h);
    const Vec2 corner = corner_of_domain(options, mesh);
    return {std::move(mesh), corner, {}};
}

/// Gives power cells between walls back the areas that they had before their corners were moved.
/// @param cells, joined  with their mirror images.
FittedCells fit_between_walls(const TileOptions& options, const PeriodicMesh& cells,
                              PeriodicMesh joined, double h, const Eigen::VectorXd& weights) {
    const auto n = static_cast<int>(weights.size());
    const int copies = options.columns * options.rows;
    const WalledDomain domain = walled_domain(options);
    const AreaMeasure measure = [&](const PeriodicMesh& mesh) -> Eigen::VectorXd {
        const auto box =
            box_between_walls(options, repeated(mesh, options.columns, options.rows), domain, h);
        if (!box) return areas_by_site(mesh, n);
        const auto places = places_between_walls(box->pieces, domain);
        const PeriodicMesh between = mesh_between_walls(box->pieces, places, domain);
        return areas_by_site(between, n) * domain.n_images() / copies;
    };
    return fit_areas(cells, std::move(joined), Metric(), weights, measure);
}

/// The cells between walls with their images, halved where their sites lie on walls.
/// @param weights  empty, or of the sites of the torus.
TorusMesh walled_torus_mesh(const TileOptions& options, PeriodicMesh domain, double h,
                            const Eigen::VectorXd& weights, TileFigures& figures) {
    if (options.kind == MeshKind::kDelaunay) return torus_mesh(options, std::move(domain), h);
    const WalledDomain& walled = *options.walled;
    PeriodicMesh cells = std::move(domain);
    PeriodicMesh joined = cells;
    if (options.kind == MeshKind::kGrains) joined.whole_sides = cell_sides(joined);
    const double shortest = shortest_edge(options);
    if (shortest > 0) {
        joined = without_short_edges(joined, shortest * h, walled, still_vertices(options, joined));
    }
    joined = mirrored_mesh(std::move(joined), walled);
    TorusMesh torus{.mesh = std::move(joined), .corner = options.origin};
    if (weights.size() > 0) {
        cells = mirrored_mesh(std::move(cells), walled);
        FittedCells fitted = fit_between_walls(options, cells, std::move(torus.mesh), h,
                                               weights.head(walled.n_sites));
        figures.area_error = fitted.largest_relative_error;
        torus.mesh = std::move(fitted.cells);
        torus.weights = std::move(fitted.weights);
    }
    torus.mesh = repeated(std::move(torus.mesh), options.columns, options.rows);
    return torus;
}

/// Power cells, which keep their areas without their short edges, and at the sides of a box.
TorusMesh power_torus_mesh(const TileOptions& options, PeriodicMesh cells, double h,
                           const Eigen::VectorXd& weights, TileFigures& figures) {
    PeriodicMesh joined = without_shortest(cells, options, h);
    const Vec2 corner = corner_of_domain(options, repeated(joined, options.columns, options.rows));
    const Metric metric = options.elongation ? options.elongation->metric : Metric();
    FittedCells fitted =
        options.outline == Outline::kWhole
            ? fit_areas(cells, std::move(joined), metric, weights)
            : fit_areas_in_box(cells, joined, metric, weights,
                               {options.columns, options.rows, corner, snap_distance(options, h)});
    figures.area_error = fitted.largest_relative_error;
    return {repeated(std::move(fitted.cells), options.columns, options.rows), corner,
            std::move(fitted.weights), std::move(fitted.cut)};
}

LaidOut lay_out(const TileOptions& options, TorusMesh torus, double h, TileFigures& figures) {
    PeriodicMesh& mesh = torus.mesh;
    if (options.outline == Outline::kWhole) {
        const Domain domain(mesh.lattice, options.origin);
        figures.domain_corner = domain.corner();
        figures.opposite_corner = domain.opposite_corner();
        std::vector<Offset> placement = whole_outline(mesh, options.origin);
        return {std::move(mesh), std::move(placement)};
    }
    figures.domain_corner = torus.corner;
    figures.opposite_corner = torus.corner + mesh.lattice.a() + mesh.lattice.b();
    BoxCut box = torus.cut ? std::move(*torus.cut)
                           : cut_along_box(mesh, torus.corner, snap_distance(options, h),
                                           {.still = still_vertices(options, mesh)});
    figures.box_shortest_edge = box.shortest_edge / h;
    std::vector<Offset> placement(static_cast<std::size_t>(box.pieces.n_faces()));
    return {std::move(box.pieces), std::move(placement)};
}

}  // namespace

BuiltTile build_tile(const PeriodicDelaunay& delaunay, const TileOptions& options) {
    return build_tile(domain_mesh(delaunay, options), delaunay, options);
}

BuiltTile build_tile(PeriodicMesh domain, const PeriodicDelaunay& delaunay,
                     const TileOptions& options) {
    const double h = delaunay.sites().spacing();
    TileFigures figures{.kind = options.kind};
    const bool is_power = delaunay.weights().size() > 0 && options.kind != MeshKind::kDelaunay;
    TorusMesh torus;
    if (options.walled) {
        torus = walled_torus_mesh(options, std::move(domain), h, delaunay.weights(), figures);
    } else if (is_power) {
        torus = power_torus_mesh(options, std::move(domain), h, delaunay.weights(), figures);
    } else {
        torus = torus_mesh(options, std::move(domain), h);
    }
    if (options.kind == MeshKind::kDelaunay && delaunay.weights().size() > 0) {
        const int n = options.walled ? options.walled->n_sites : delaunay.sites().n_sites();
        torus.weights = delaunay.weights().head(n);
    }
    const Eigen::VectorXd weights = torus.weights;
    report(options, kGrainsBegin);
    LaidOut laid_out = options.walled
                           ? lay_out_between_walls(options, std::move(torus.mesh), h, figures)
                           : lay_out(options, std::move(torus), h, figures);
    if (options.kind == MeshKind::kGrains) laid_out = mesh_cells(options, laid_out, h, figures);
    report(options, kGrainsEnd);
    Tile tile = tile_of(options, laid_out);
    if (options.elongation) tile.metric = options.elongation->metric;
    tile.site_weights.assign(weights.begin(), weights.end());
    tile.grain_site_points = std::move(laid_out.grain_site_points);
    tile.columns = options.columns;
    tile.rows = options.rows;
    tile.short_edges = options.short_edges;
    if (options.kind == MeshKind::kGrains) tile.order = options.order;
    tile = with_holes(std::move(tile), options.holes);
    figures.n_edge_pairs = static_cast<int>(tile.edge_pairs.size());
    figures.n_wall_edges = static_cast<int>(tile.wall_edges.size());
    figures.n_boundary_edges = 2 * figures.n_edge_pairs + figures.n_wall_edges;
    return {std::move(tile), std::move(figures)};
}

}  // namespace pcvt::plane
