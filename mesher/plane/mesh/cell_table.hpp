#pragma once

#include <vector>

#include "mesher/plane/mesh/periodic_mesh.hpp"

namespace pcvt::plane {

/// Measures of the cells of a torus, one entry a site. Laws, tested by number:
///   (1) The areas sum to that of the domain.
///   (2) If no edge is shorter than kShortEdge h and three cells meet at every vertex, the sides
///       sum to 6 n.
///   (3) Without shorter edges, s has t as a neighbour once for each Delaunay edge from s to t.
struct CellTable {
    /// length^2
    std::vector<double> area;
    /// length units
    std::vector<double> perimeter;
    /// The number of edges longer than kShortEdge h (valence.hpp); those on walls count.
    std::vector<int> sides;
    /// The sites across the sides of cell s, counter-clockwise: neighbours[neighbour_begin[s]] ...
    /// neighbours[neighbour_begin[s + 1] - 1]. A site may occur twice, and it may be s itself.
    std::vector<int> neighbour_begin{0};
    std::vector<SiteId> neighbours;

    int n_cells() const { return static_cast<int>(area.size()); }
    int n_neighbours(SiteId s) const { return neighbour_begin[s + 1] - neighbour_begin[s]; }
    /// 2 sqrt(area / pi), length units.
    double equivalent_diameter(SiteId s) const;
    /// Perimeter of the circle with the area of the cell over the perimeter of the cell,
    /// 2 sqrt(pi area) / perimeter: 1 for a circle, 0.952 for a regular hexagon.
    double circularity(SiteId s) const;
};

/// Example usage:
///   const CellTable cells = cell_table(cell_mesh(delaunay));
///   for (SiteId s = 0; s < cells.n_cells(); ++s) total += cells.area[s];
///
/// @param cells  whole cells, face s that of site s.
CellTable cell_table(const PeriodicMesh& cells);

}  // namespace pcvt::plane
