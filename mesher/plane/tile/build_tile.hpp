#pragma once

#include <optional>
#include <vector>

#include "mesher/plane/delaunay/periodic_delaunay.hpp"
#include "mesher/plane/mesh/tile_options.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt::plane {

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
    /// The number of boundary edges on walls.
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
///   BuiltTile grains = build_tile(result.delaunay, {.kind = MeshKind::kGrains, .repeat = {2, 1}});
///   verify_generated_tile(grains.tile);
///
/// Repeats the tessellation, removes short edges (power cells keep their areas, by other weights:
/// area_fit.hpp), lays the faces out in the outline, and meshes the
/// grains. The tile is not proved yet: verify_generated_tile() does that.
/// @pre Delaunay triangles between walls: no site off a wall has an edge of its cell there.
/// @throws InvalidInput   the cells are so small that their corners coincide.
/// @throws LimitExceeded  grains too fine, or a piece of a cell too thin for them.
BuiltTile build_tile(const PeriodicDelaunay& delaunay, const TileOptions& options);

/// The same from domain_mesh().
BuiltTile build_tile(PeriodicMesh domain, const PeriodicDelaunay& delaunay,
                     const TileOptions& options);

}  // namespace pcvt::plane
