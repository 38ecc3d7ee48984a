#pragma once

#include <optional>

#include "mesher/predicates.hpp"
#include "mesher/torus_triangulation.hpp"

namespace pcvt {

/// Sites sorted into columns across the reduced domain: by the first coordinate into columns, in a
/// column by the second one.
struct Columns {
    /// The sites, column by column.
    std::vector<SiteId> order;
    /// Column k holds order[begin[k]] ... order[begin[k + 1] - 1]; no column is empty.
    std::vector<int> begin;

    int n_columns() const { return static_cast<int>(begin.size()) - 1; }
};

/// About sqrt(n) columns with nearly equal counts, as many as make the sites of a column as far
/// apart as the columns; neighbours in `order` are near to each other in the plane.
/// @param coordinates  2 x n, reduced basis, in [0, 1)^2.
Columns sort_into_columns(const Points& coordinates, const Gram& gram);

/// Some triangulation of the torus, from any n >= 1 on: the start for Lawson's flips.
///
/// The sites of a column, joined in their order, form a chain that closes round the torus and is
/// monotone in the second coordinate. The annular strip between two neighbouring chains is
/// triangulated as a monotone polygon (M. Garey et al. 1978), cut open along one edge between the
/// chains. Linear in n. The triangles are linked as they are made, strip by strip.
/// @returns nothing where chains touch (equal first coordinates in two columns) or where a triangle
///          would be collinear up to rounding.
std::optional<TorusTriangulation> strip_triangulation(const Points& coordinates,
                                                      const Columns& columns);

}  // namespace pcvt
