#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "mesher/plane/delaunay/periodic_delaunay.hpp"
#include "mesher/plane/mesh/elongated_mesh.hpp"
#include "mesher/plane/mesh/outline.hpp"
#include "mesher/plane/mesh/walled_mesh.hpp"
#include "mesher/plane/tile/tile.hpp"
#include "mesher/plane/tile/tile_holes.hpp"

namespace pcvt::plane {

/// How a tile is made from a tessellation; h = sqrt(area / number of sites).
struct TileOptions {
    MeshKind kind = MeshKind::kVoronoi;
    /// Delaunay triangles have no box outline.
    Outline outline = Outline::kWhole;
    /// Voronoi edges shorter than this are removed from cells and grains, units of h; 0: none, but
    /// for the shortest ones of grains (mesher/plane/grains/grains.hpp).
    double short_edges = 0;
    /// Edges of grains, length units; 0: h / 3.
    double grain_size = 0;
    /// The number of parts of each edge of the cells; excludes grain_size. 0: none.
    int grain_per_edge = 0;
    /// Of grains, as Tile::order.
    int order = 1;
    /// The tile covers columns x rows domains and is a tile of that lattice.
    int columns = 1;
    int rows = 1;
    /// Corner of the domain, length units.
    Vec2 origin = Vec2::Zero();
    /// Moves the box outline to where its shortest edge is longest, instead of to `origin`.
    bool finds_origin = false;
    /// Maps cells that were computed in the round space of a metric back to the plane.
    std::optional<Elongation> elongation = {};
    /// The tessellation consists of a domain between walls and its mirror images; the tile is that
    /// of the domain. Excludes elongation, finds_origin, copies across walls, and an origin off the
    /// walls.
    std::optional<WalledDomain> walled = {};
    /// Of cells beside interfaces: a tag for each site. Edges with an end where cells of different
    /// tags meet are not removed. Empty: all cells are alike. Excludes weights and walls.
    std::span<const int> site_tags = {};
    /// The sites whose cells are left out. Excludes weights.
    HoleSites holes = {};
    /// Called now and then with the share that is done, about, from 0 to 1; what it throws ends the
    /// building.
    std::function<void(double)> progress = {};
};

/// A corner of a cell or piece that is too sharp for the angles of its grains.
struct SharpGrainCorner {
    SiteId site;
    Vec2 point;
    /// Degrees.
    double angle;
};

struct GrainFigures {
    int n_triangles;
    /// Degrees, of all angles but those in the sharp corners.
    double smallest_angle;
    std::vector<SharpGrainCorner> sharp_corners;
};

/// Numbers of one tile: its seam, its outline, its grains.
struct TileFigures {
    MeshKind kind;
    int n_boundary_edges = 0;
    int n_edge_pairs = 0;
    /// Of the boundary edges.
    int n_wall_edges = 0;
    /// Two opposite corners of the domain round which the tile is laid.
    Vec2 domain_corner = Vec2::Zero();
    Vec2 opposite_corner = Vec2::Zero();
    /// The box outline: the shortest edge that the cut has made, in units of h.
    std::optional<double> box_shortest_edge = {};
    std::optional<GrainFigures> grains = {};
    /// Cells and grains of power cells: the largest relative difference between the area of a cell
    /// in the tile and that of its power cell.
    std::optional<double> area_error = {};
};

struct BuiltTile {
    Tile tile;
    TileFigures figures;
};

/// Builds a tile from a tessellation.
///
/// Example usage:
///   BuiltTile grains = build_tile(result.delaunay, {.kind = MeshKind::kGrains, .columns = 2});
///   verify_generated_tile(grains.tile);
///
/// Repeats the tessellation, removes short edges (power cells keep their areas, by other weights:
/// area_fit.hpp), lays the faces out in the outline, and meshes the
/// grains. The tile is not proved yet: verify_generated_tile() does that.
/// @pre Delaunay triangles between walls: no site off a wall has an edge of its cell there.
/// @throws InvalidInput   the cells are so small that their corners coincide.
/// @throws LimitExceeded  grains too fine, or a piece of a cell too thin for them.
BuiltTile build_tile(const PeriodicDelaunay& delaunay, const TileOptions& options);

/// The same from the cells of the triangulation, in the plane of the user and with walls those
/// between them (part_between_walls()), or, of the kind kDelaunay, from its triangles.
BuiltTile build_tile(PeriodicMesh domain, const PeriodicDelaunay& delaunay,
                     const TileOptions& options);

}  // namespace pcvt::plane
