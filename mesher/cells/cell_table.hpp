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
    /// 2 in the plane, 3 in space.
    int dimension = 2;
    /// Areas in the plane, length^2; volumes in space, length^3.
    std::vector<double> measure;
    /// Perimeters in the plane, length units; areas of the surfaces in space, length^2.
    std::vector<double> surface;
    /// The number of edges, or of faces; those on walls count.
    std::vector<int> sides;
    /// The sites across the sides of cell s, in the plane counter-clockwise, in space rising:
    /// neighbours[neighbour_begin[s]] ... neighbours[neighbour_begin[s + 1] - 1]. A site may occur
    /// twice, and it may be s itself.
    std::vector<int> neighbour_begin{0};
    std::vector<SiteId> neighbours;

    int n_cells() const { return static_cast<int>(measure.size()); }
    int n_neighbours(SiteId s) const { return neighbour_begin[s + 1] - neighbour_begin[s]; }
    /// The diameter of the circle or the sphere with the measure of the cell, length units:
    /// 2 sqrt(area / pi), or (6 volume / pi)^(1/3).
    double equivalent_diameter(SiteId s) const;
    /// The surface of the circle or the sphere with the measure of the cell over that of the cell:
    /// the circularity 2 sqrt(pi area) / perimeter, 0.952 for a regular hexagon, or the sphericity
    /// pi^(1/3) (6 volume)^(2/3) / area, 0.910 for a truncated octahedron.
    double roundness(SiteId s) const;
};

}  // namespace pcvt
