#pragma once

#include <string>

#include "io/gltf/triangle_fan.hpp"
#include "mesher/tile/tile.hpp"

namespace pcvt {

using Point3 = std::array<float, 3>;

/// The triangles of a tile as they go into a glTF file.
struct Surface {
    /// Those of the tile, then more copies of them.
    std::vector<Point32> points;
    /// Vertex points.size() - copies.size() + k is a copy of vertex copies[k].
    std::vector<int> copies;
    std::vector<int> indices;
    /// Triangles of face f: indices[face_begin[f]] ... indices[face_begin[f + 1] - 1].
    std::vector<int> face_begin{0};
    /// One a vertex, or empty.
    std::vector<float> vertex_site;
    std::vector<Point3> vertex_colour;
};

/// Cells: vertices are shared while `max_shared` allows that many faces, else each cell has its own
/// (the first cell at a vertex keeps it, each other one gets a copy) with the site and the colour
/// of the cell. Grains: the same, with vertices shared within a grain. Delaunay triangles: vertices
/// are shared, with site and colour of the vertex.
/// @throws InvalidInput naming the path where float32 cannot hold a coordinate or the area of a
/// cell.
Surface make_surface(const Tile& tile, int max_shared, const std::string& path);

}  // namespace pcvt
