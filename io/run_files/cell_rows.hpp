#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "mesher/cells/cell_materials.hpp"
#include "mesher/cells/cell_table.hpp"

namespace pcvt {

/// The rows of a table of cells, one a site.
struct CellRows {
    /// 2 x n in the plane, 3 x n in space, length units.
    Eigen::MatrixXd sites;
    CellTable cells;
    /// length^2, one a site; empty without weights.
    Eigen::VectorXd weights = {};
    CellMaterials materials = {};
    /// Whether the phases are the tags of inclusions.
    bool phases_are_tags = false;
    /// In the plane: the orbit of each site under the symmetry of the run; empty without one.
    std::vector<int> orbits = {};
};

/// The names of the columns, with commas between them.
inline constexpr const char* kCellHeader =
    "site,x,y,weight,area,diameter,sides,circularity,phase,tag,phi1,Phi,phi2,orbit,neighbours";
inline constexpr const char* kSpaceCellHeader =
    "site,x,y,z,weight,volume,diameter,faces,sphericity,phase,tag,phi1,Phi,phi2,neighbours";

/// The header of a table of cells of this dimension.
inline const char* cell_header(int dimension) {
    return dimension == 3 ? kSpaceCellHeader : kCellHeader;
}

/// Gives the fields of row s to a writer or a reader, in the order of the columns: number(x),
/// text(word), and list(first, last) of the neighbours. A field that does not apply is the text "".
///
/// Example usage:
///   FieldWriter fields(text);
///   for_each_field(rows, s, fields);
template <class Fields>
void for_each_field(const CellRows& rows, SiteId s, Fields& fields) {
    const CellTable& cells = rows.cells;
    const CellMaterials& materials = rows.materials;
    fields.number(s);
    for (Eigen::Index axis = 0; axis < rows.sites.rows(); ++axis)
        fields.number(rows.sites(axis, s));
    if (rows.weights.size() > 0) {
        fields.number(rows.weights[s]);
    } else {
        fields.text("");
    }
    fields.number(cells.measure[s]);
    fields.number(cells.equivalent_diameter(s));
    fields.number(cells.sides[s]);
    fields.number(cells.roundness(s));
    const std::string phase = materials.phase_of(s);
    fields.text(phase);
    fields.text(rows.phases_are_tags ? phase : "");
    if (materials.site_orientation.empty()) {
        for (int k = 0; k < 3; ++k) fields.text("");
    } else {
        const BungeAngles& angles = materials.site_orientation[s];
        for (const double angle : {angles.phi1, angles.Phi, angles.phi2}) fields.number(angle);
    }
    if (cells.dimension == 2) {
        if (rows.orbits.empty()) {
            fields.text("");
        } else {
            fields.number(rows.orbits[s]);
        }
    }
    fields.list(cells.neighbours.data() + cells.neighbour_begin[s],
                cells.neighbours.data() + cells.neighbour_begin[s + 1]);
}

}  // namespace pcvt
