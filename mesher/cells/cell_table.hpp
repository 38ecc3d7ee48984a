#pragma once

#include <vector>

#include "mesher/base/site_id.hpp"

namespace pcvt {

/// Measures of the cells of a torus, one entry a site.
///
/// Example usage:
///   const CellTable cells = plane::cell_table(plane::cell_mesh(delaunay));
///   for (SiteId s = 0; s < cells.n_cells(); ++s) total += cells.measure[s];
struct CellTable {
    /// Areas in the plane, length^2; volumes in space, length^3.
    std::vector<double> measure;
    /// Perimeters in the plane, length units; areas of the surfaces in space, length^2.
    std::vector<double> surface;
    /// The number of edges, or of faces; those on walls count.
    std::vector<int> sides;
    /// The sites across the sides of cell s, in the plane counter-clockwise:
    /// neighbours[neighbour_begin[s]] ... neighbours[neighbour_begin[s + 1] - 1]. A site may occur
    /// twice, and it may be s itself.
    std::vector<int> neighbour_begin{0};
    std::vector<SiteId> neighbours;

    int n_cells() const { return static_cast<int>(measure.size()); }
    int n_neighbours(SiteId s) const { return neighbour_begin[s + 1] - neighbour_begin[s]; }
    /// In the plane: 2 sqrt(area / pi), length units.
    double equivalent_diameter(SiteId s) const;
    /// In the plane: perimeter of the circle with the area of the cell over the perimeter of the
    /// cell, 2 sqrt(pi area) / perimeter: 1 for a circle, 0.952 for a regular hexagon.
    double circularity(SiteId s) const;
};

}  // namespace pcvt
