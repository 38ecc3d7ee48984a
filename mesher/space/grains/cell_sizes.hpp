#pragma once

#include <vector>

#include "mesher/space/mesh/cell_complex.hpp"

namespace pcvt::space {

/// The largest size of the tetrahedra in a cell over the cube root of its volume.
inline constexpr double kLargestSize = 0.7;
/// The same over the width of the cell: one layer of larger tetrahedra has small angles.
inline constexpr double kSizeInWidth = 2;
/// The width makes the size smaller by this factor at most: flatter whole cells keep the size that
/// they have without it, since a plate would take a thousand times as many tetrahedra.
inline constexpr double kLeastSize = 0.3;
/// Cells narrower than this part of the wanted size are named.
inline constexpr double kFlatWidth = 0.7;

/// A cell that is too flat for the wanted size.
struct FlatCell {
    SiteId cell;
    /// The arc tangent of its width over the wanted size, degrees.
    double angle;
};

struct CellSizes {
    /// The target length of edges in each cell, length units.
    std::vector<double> sizes = {};
    std::vector<FlatCell> flat = {};
};

/// Returns sizes: `size`, or a third of the cube root of the volume of each cell if that is 0.
/// The volume of a piece counts as that of its whole cell.
///
/// Law, tested by number:
///   (1) No size is above kLargestSize of the cube root of the volume of its cell; and except in
///       flat cells none is above kSizeInWidth of the least distance between two parallel planes
///       with the cell between them, one of them in a face.
CellSizes cell_sizes(const CellComplex& complex, double size);

}  // namespace pcvt::space
