#pragma once

#include <vector>

#include "mesher/space/mesh/cell_complex.hpp"

namespace pcvt::space {

/// The largest size of the tetrahedra in a cell over the cube root of its volume.
inline constexpr double kLargestSize = 0.7;
/// The same over the width of the cell, so that tetrahedra have a good shape.
inline constexpr double kSizeInWidth = 0.7;
/// The width makes the size smaller by this factor at most: flatter cells keep the size that they
/// have without it, and get small angles.
inline constexpr double kLeastSizeInWidth = 0.5;

/// A cell that is too flat for its size.
struct FlatCell {
    SiteId cell;
    /// The arc tangent of its width over its size, degrees.
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
