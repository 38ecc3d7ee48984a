#pragma once

#include <map>

#include "mesher/mesh/periodic_mesh.hpp"

namespace pcvt {

/// Edges shorter than this, in units of h = sqrt(area / n_faces), do not count as sides of a cell.
inline constexpr double kShortEdge = 1e-5;

/// For each cell the number of its edges longer than kShortEdge h; for each piece of a cell and
/// each triangle of a grain that of the whole cell, where the mesh knows it.
std::vector<int> cell_sides(const PeriodicMesh& cells);
std::vector<int> cell_sides(const FlatTile& cells);

/// For each vertex of a triangle tile the number of triangles at its orbit: the valence of the
/// site.
std::vector<int> vertex_valences(const FlatTile& triangles);

/// How often each number of sides occurs.
std::map<int, int> histogram(const std::vector<int>& sides);

}  // namespace pcvt
