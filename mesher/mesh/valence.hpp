#pragma once

#include <map>
#include <span>
#include <vector>

#include "mesher/mesh/periodic_mesh.hpp"

namespace pcvt {

/// Edges shorter than this, in units of h = sqrt(area / n_faces), do not count as sides of a cell.
inline constexpr double kShortEdge = 1e-5;

/// The number of edges of a polygon that are longer than `shortest`, length units.
int count_sides(std::span<const Vec2> polygon, double shortest);

/// For each cell the number of its edges longer than kShortEdge h; for each piece of a cell and
/// each triangle of a grain that of the whole cell, where the mesh knows it.
std::vector<int> cell_sides(const PeriodicMesh& cells);

/// How often each number of sides occurs.
std::map<int, int> histogram(const std::vector<int>& sides);

}  // namespace pcvt
