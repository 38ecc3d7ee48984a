#pragma once

#include <string>
#include <vector>

#include "mesher/base/faces.hpp"
#include "mesher/cells/set_names.hpp"
#include "mesher/plane/geometry/metric.hpp"
#include "mesher/plane/geometry/sites.hpp"
#include "mesher/plane/geometry/walled_domain.hpp"
#include "mesher/plane/mesh/mesh_kind.hpp"

namespace pcvt::plane {

/// position(w) = position(v) + translation(offset).
struct VertexPair {
    int v;
    int w;
    Offset offset;
    friend constexpr auto operator<=>(const VertexPair&, const VertexPair&) = default;
};

/// The boundary edge v0 -> v1 (its face on the left) is glued to w0 -> w1, whose face lies on the
/// right: position(w_k) = position(v_k) + translation(offset) for k = 0 and 1.
struct EdgePair {
    int v0;
    int v1;
    int w0;
    int w1;
    Offset offset;

    /// The same gluing with the sides exchanged: w1 -> w0 is glued to v1 -> v0.
    constexpr EdgePair reversed() const {
        return {.v0 = w1, .v1 = w0, .w0 = v1, .w1 = v0, .offset = -offset};
    }
    friend constexpr auto operator<=>(const EdgePair&, const EdgePair&) = default;
};

/// A wall of a tile: a side of the domain, by its WallSide, or the edge of a hole, by its number
/// among Tile::holes, which follow the sides.
///
/// Example usage:
///   const WallId wall = WallId::hole(0);
///   assert(wall_name(tile, wall) == tile.holes[0]);
struct WallId {
    int number;

    static constexpr WallId side(WallSide side) { return {static_cast<int>(side)}; }
    static constexpr WallId hole(int hole) { return {static_cast<int>(kWallSides.size()) + hole}; }
    constexpr bool is_hole() const { return number >= static_cast<int>(kWallSides.size()); }
    /// @pre !is_hole().
    constexpr WallSide side() const { return static_cast<WallSide>(number); }
    /// @pre is_hole().
    constexpr int hole() const { return number - static_cast<int>(kWallSides.size()); }
    friend constexpr auto operator<=>(const WallId&, const WallId&) = default;
};

/// The boundary edge v0 -> v1 (its face on the left) lies on a wall.
struct WallEdge {
    WallId wall;
    int v0;
    int v1;
    friend constexpr auto operator<=>(const WallEdge&, const WallEdge&) = default;
};

/// A tile as plain arrays, which writers take and readers return.
///
/// Offsets are in the basis of `lattice`, the one that the user typed (times the repetition).
struct Tile {
    Lattice lattice;
    MeshKind kind;
    /// One position a vertex, length units.
    std::vector<Vec2> points = {};
    /// On these points, counter-clockwise.
    Faces faces = {};
    /// Cells and grains: one site a face. Delaunay triangles: empty.
    std::vector<SiteId> face_site = {};
    /// Delaunay triangles: one site a vertex. Else: empty.
    std::vector<SiteId> vertex_site = {};
    /// One pair for each vertex w that is not the representative v of its orbit, by rising w.
    /// The representative is the vertex of the orbit with the smallest index, so v < w.
    std::vector<VertexPair> vertex_pairs = {};
    /// Each identified pair of boundary edges once. Boundary edges are in a pair or on a wall, and
    /// the edge of a hole is a wall.
    std::vector<EdgePair> edge_pairs = {};
    /// The sides of the domain that are walls, which no offset crosses. The lattice is then upright
    /// (is_upright()), and the walls lie at 0 and at its sides to the last bit.
    Walls walls = Walls::kNone;
    /// The names of the holes, where the faces of some cells are left out (tile_holes.hpp); several
    /// holes may share a name. Such a tile is not a disc, and need not be connected before gluing.
    std::vector<std::string> holes = {};
    /// Every edge on a wall once, sorted.
    std::vector<WallEdge> wall_edges = {};
    /// Cells of a tile in memory: the position of the site of each face. Files do not hold it.
    std::vector<Vec2> site_points = {};
    /// Grains of a tile in memory: the position of the site of the cell to which each face belongs,
    /// which distinguishes a cell from its images. Files do not hold it.
    std::vector<Vec2> grain_site_points = {};
    /// The tile covers columns x rows periods of its sites; 0: not known.
    int columns = 0;
    int rows = 0;
    /// Edges of cells shorter than this may have been removed, units of h = sqrt(area / number of
    /// cells); 1: not known.
    double short_edges = 1;
    /// Files that hold them: where each site lies, in the domain of the first face (vertex) that
    /// names it. Tiles in memory: empty; site_positions() computes them.
    std::vector<Vec2> site_positions = {};
    /// Power cells: the weight of each site 0 ... n - 1, length^2. Else: empty.
    std::vector<double> site_weights = {};
    /// Elongated cells: the metric in which they are the cells of their sites.
    Metric metric = {};
    /// Files whose faces do not share all of their vertices: for each of the last vertices the
    /// earlier one, itself no copy, whose position it repeats. May be empty all the same.
    std::vector<int> copies = {};
    /// Pieces of cells and grains of a tile in memory: the sides of the whole cell that each face
    /// is part of. Whole cells, Delaunay triangles and files: empty.
    std::vector<int> whole_sides = {};
    /// 2: triangles have a node in the middle of each edge as well
    /// (mesher/plane/tile/midside_nodes.hpp).
    int order = 1;

    int n_vertices() const { return static_cast<int>(points.size()); }
    int n_faces() const { return faces.n_faces(); }
    int face_size(int f) const { return faces.size(f); }
    /// One site a face, or one a vertex.
    const std::vector<SiteId>& sites() const {
        return faces_have_sites(kind) ? face_site : vertex_site;
    }
};

/// The name of a wall, in every format: `wall_left`, or the name of the hole.
inline std::string wall_name(const Tile& tile, WallId wall) {
    if (wall.is_hole()) return tile.holes[static_cast<std::size_t>(wall.hole())];
    return wall_side_row(wall.side()).word;
}

}  // namespace pcvt::plane
