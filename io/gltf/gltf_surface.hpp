#pragma once

#include <string>

#include "io/tiles/file_options.hpp"
#include "io/tiles/triangle_fan.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

using Point3 = std::array<float, 3>;

/// Consecutive triangles of one colour.
struct SurfaceGroup {
    /// The class of their colour.
    int colour;
    /// -1 where the group holds all cells of this colour.
    SiteId site;
};

/// Consecutive triangles of one cell.
struct CellTriangles {
    SiteId site;
    int n_triangles;
};

/// The triangles of a tile as a glTF file stores them, on the vertices of the tile.
struct Surface {
    std::vector<Point32> points;
    std::vector<int> indices;
    /// Cells and grains: group g has the corners indices[group_begin[g]] ...
    /// indices[group_begin[g + 1] - 1], three per triangle.
    std::vector<SurfaceGroup> groups;
    std::vector<int> group_begin{0};
    /// Cells and grains in one node: the cells in the order of their triangles.
    std::vector<CellTriangles> cells;
    /// Delaunay triangles: the colour of each vertex.
    std::vector<Point3> vertex_colour;

    bool is_one_node() const { return !cells.empty() || groups.empty(); }
};

/// Returns the surface of a tile. Cells and grains have one group for each cell, or in one node one
/// for each colour.
/// @throws CoarsePrecision naming the path if float32 cannot hold a coordinate or the area of a
/// cell.
Surface make_surface(const plane::Tile& tile, const TileColours& colours, GltfNodes nodes,
                     const std::string& path);

}  // namespace pcvt
