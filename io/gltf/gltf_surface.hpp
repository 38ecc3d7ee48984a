#pragma once

#include <string>

#include "io/gltf/triangle_fan.hpp"
#include "mesher/tile/tile.hpp"

namespace pcvt {

using Point3 = std::array<float, 3>;

/// The triangles of a tile as a glTF file stores them.
struct Surface {
    /// The vertices of the tile, followed by the copies.
    std::vector<Point32> points;
    /// Vertex points.size() - copies.size() + k is a copy of vertex copies[k].
    std::vector<int> copies;
    std::vector<int> indices;
    /// Face f has the corners indices[face_begin[f]] ... indices[face_begin[f + 1] - 1], three per
    /// triangle.
    std::vector<int> face_begin{0};
    /// One site and one colour per vertex, or empty.
    std::vector<float> vertex_site;
    std::vector<Point3> vertex_colour;
};

/// Returns the surface of a tile.
///
///   Cells               share their vertices if there are at most `max_shared`. Else each cell has
///                       vertices of its own, with its site and colour: the first cell at a vertex
///                       keeps it, every other cell gets a copy.
///   Grains              always have vertices of their own, shared by the triangles of a grain.
///   Delaunay triangles  share their vertices, each with its own site and colour.
///
/// @throws InvalidInput naming the path if float32 cannot hold a coordinate or the area of a cell.
Surface make_surface(const Tile& tile, int max_shared, const std::string& path);

}  // namespace pcvt
