#pragma once

#include <array>
#include <string>
#include <vector>

#include "io/forms/file_options.hpp"
#include "io/forms/file_tetrahedra.hpp"
#include "io/forms/numbered_items.hpp"
#include "io/forms/triangle_cells.hpp"
#include "io/solvers/inp_form.hpp"

namespace pcvt {

/// Returns the height of the layer of wedges of a file, length units; without a choice of the user
/// that of a prism as high as the mean side of its triangles.
double wedge_thickness(const plane::Tile& tile, const FileOptions& options);

/// Extrudes the form of a tile of triangles to one layer of wedges, C3D6 or C3D15 (wedges.hpp),
/// which is periodic along z as well.
///
/// Sets of nodes hold the nodes above theirs as well; TRIPLE_POINTS becomes TRIPLE_LINES, seam_I_J
/// becomes seam_I_J_0, and seam_0_0_1 and seam_0_0_-1 are the bottom and the top. A box has the
/// sets of box_sets(), too. Surfaces consist of the sides above those of the triangles; there are
/// also `GRAIN_BOUNDARY_SIDES` and `PHASE_A_TO_B`, as encode_tetrahedra_inp() has them.
void extrude(const plane::Tile& tile, const TriangleCells& cells, const CellMaterials& materials,
             double thickness, InpForm& form);

/// A node of a file that three equations tie to another one.
struct NumberedTie {
    int node;
    int master;
    int line;
    /// position(node) = position(master) + translation.
    std::array<double, 3> translation;
};

/// The numbered items of a file with one layer of wedges, as extrude() numbers them.
struct FileWedges {
    /// The name of the file in messages, and the third period.
    std::string name;
    double thickness;
    std::vector<NumberedPoint> nodes = {};
    std::vector<NumberedItems::Triangle> elements = {};
    std::vector<NumberedTie> ties = {};
};

/// Proves that the nodes, the wedges and the ties are those of a layer, and leaves only the ones of
/// its triangles: heights within 4 ulps of the largest coordinate, all else exactly.
/// @throws BadFile  with the line.
void flatten(FileWedges& file);

}  // namespace pcvt
