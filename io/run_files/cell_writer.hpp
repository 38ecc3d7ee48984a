#pragma once

#include <string>
#include <vector>

#include "mesher/cells/cell_materials.hpp"
#include "mesher/cells/cell_table.hpp"
#include "mesher/plane/geometry/lattice.hpp"

namespace pcvt {

/// The rows of a table of cells, one a site.
struct CellRows {
    /// 2 x n, length units.
    plane::Points sites;
    CellTable cells;
    /// length^2, one a site; empty without weights.
    Eigen::VectorXd weights = {};
    CellMaterials materials = {};
    /// Whether the phases are the tags of inclusions.
    bool phases_are_tags = false;
    /// The orbit of each site under the symmetry of the run; empty without one.
    std::vector<int> orbits = {};
};

/// Encodes the cells as a .csv file: comments that begin with #, a header, one row a site. Fields
/// that do not apply to the cells are empty. The neighbours of a cell are separated by blanks.
///
/// Example usage:
///     output.stage("cells.csv", encode_cells({sites, cell_table(cells)}));
///
/// @throws InternalError if a number is not finite.
std::string encode_cells(const CellRows& rows);

/// The names of the columns, with commas between them.
inline constexpr const char* kCellHeader =
    "site,x,y,weight,area,diameter,sides,circularity,phase,tag,phi1,Phi,phi2,orbit,neighbours";

}  // namespace pcvt
