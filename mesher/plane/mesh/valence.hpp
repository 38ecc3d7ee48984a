#pragma once

#include <map>
#include <span>
#include <vector>

#include "mesher/plane/mesh/periodic_mesh.hpp"

namespace pcvt::plane {

/// Edges shorter than this, in units of h = sqrt(area / n_faces), do not count as sides of a cell.
inline constexpr double kShortEdge = 1e-5;

/// Returns the number of edges of a polygon that are longer than `shortest`, length units.
int count_sides(std::span<const Vec2> polygon, double shortest);

/// Returns for each cell the number of its edges longer than kShortEdge h. For pieces of cells and
/// triangles of grains, returns the number for the whole cell if the mesh stores it.
///
/// Example usage:
///   for (const auto& [sides, count] : histogram(cell_sides(cells))) {
///       std::cout << count << " cells with " << sides << " sides\n";
///   }
std::vector<int> cell_sides(const PeriodicMesh& cells);

/// Returns how often each number of sides occurs.
std::map<int, int> histogram(const std::vector<int>& sides);

}  // namespace pcvt::plane
