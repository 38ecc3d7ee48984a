#pragma once

#include "mesher/delaunay/predicates.hpp"

namespace pcvt {

/// Sites sorted into columns across the reduced domain: by the first coordinate into columns, in a
/// column by the second one.
struct SpatialSort {
    /// The sites, column by column.
    std::vector<SiteId> order;
    /// Column k holds order[begin[k]] ... order[begin[k + 1] - 1]; no column is empty.
    std::vector<int> begin;

    int n_columns() const { return static_cast<int>(begin.size()) - 1; }
};

/// About sqrt(n) columns with nearly equal counts, as many as make the sites of a column as far
/// apart as the columns; neighbours in `order` are near to each other in the plane.
/// @param coordinates  2 x n, reduced basis, in [0, 1)^2.
SpatialSort spatial_sort(const Points& coordinates, const Gram& gram);

/// The same points column by column: neighbours get numbers near to each other, and so meshes and
/// the matrices of a solver get short ways through memory.
/// @param points  2 x n, length units.
Points spatially_sorted(const Lattice& lattice, const Points& points);

}  // namespace pcvt
