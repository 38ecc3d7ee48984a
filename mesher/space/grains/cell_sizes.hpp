#pragma once

#include <vector>

#include "mesher/base/error.hpp"
#include "mesher/space/mesh/cell_complex.hpp"

namespace pcvt::space {

/// The largest size of the tetrahedra in a cell over the cube root of its volume.
inline constexpr double kLargestSize = 0.7;
/// The same over the width of the cell, so that flat cells get tetrahedra of good shape.
inline constexpr double kSizeInWidth = 0.7;

/// The tetrahedra of one cell would be more than kMostInCell.
class FlatCell : public LimitExceeded {
   public:
    FlatCell(SiteId site, double n_tetrahedra);
    SiteId site() const { return site_; }

   private:
    SiteId site_;
};

/// Returns the target length of edges in each cell, length units: `size`, or a third of the cube
/// root of the volume of the cell if that is 0, as far as cells are thick enough.
///
/// Law, tested by number:
///   (1) No size is above kLargestSize of the cube root of the volume, or above kSizeInWidth of the
///       least distance between two parallel planes with the cell between them, one of them in a
///       face.
///
/// @throws FlatCell
std::vector<double> cell_sizes(const CellComplex& complex, double size);

}  // namespace pcvt::space
