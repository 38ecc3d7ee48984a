#pragma once

#include <vector>

#include "mesher/plane/delaunay/predicates.hpp"

namespace pcvt::plane {

/// Sites sorted into columns across the reduced domain: by one coordinate into columns, and by the
/// other one within a column.
///
/// Example usage (walks the columns):
///
///     const SpatialSort sorted = spatial_sort(sites.coordinates(), gram);
///     for (int k = 0; k < sorted.n_columns(); ++k)
///         for (int m = sorted.begin[k]; m < sorted.begin[k + 1]; ++m) visit(sorted.order[m]);
struct SpatialSort {
    /// The coordinate that divides the columns, 0 or 1; the other one goes along them.
    int across = 0;
    /// The sites, column by column.
    std::vector<SiteId> order;
    /// Column k holds order[begin[k]] ... order[begin[k + 1] - 1]; no column is empty.
    std::vector<int> begin;

    int n_columns() const { return static_cast<int>(begin.size()) - 1; }
};

/// The coordinate across the columns: along the first period vector, or where the second one is
/// more than twice as long, along that one. Columns are then short, so that neighbouring columns of
/// thin domains fit into a cache.
int coordinate_across_columns(const Gram& gram);

/// Sorts into about sqrt(n) columns with nearly equal numbers of sites; the number of columns makes
/// the spacing within a column equal to the spacing of the columns. Sites that follow each other in
/// `order` are close in the plane.
/// @param coordinates  2 x n, reduced basis, in [0, 1)^2.
SpatialSort spatial_sort(const Points& coordinates, const Gram& gram);

}  // namespace pcvt::plane
