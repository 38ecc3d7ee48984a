#pragma once

#include <vector>

#include "mesher/space/mesh/cell_complex.hpp"

namespace pcvt::space {

/// Moves whole cells of a tile by translations until the faces of its seam tie every vertex and
/// every edge to its first image: of two faces that coincide modulo the lattice, the one at the
/// larger offset is the slave, and of the images of a vertex or an edge in the tile one lies on no
/// slave. Programs that link pairs of surfaces give each node on a slave one master, and no other
/// node. The same for tetrahedra: tile_ties.hpp. Pieces of cells stay in their box.
///
/// Laws, tested by number:
///   (1) The tile is connected across faces if it was before.
///   (2) A tile whose vertices and edges are tied stays as it is.
///   (3) Tetrahedra inside of the cells have no untied points (n_untied_points()).
///
/// Law (3) failed in one of 60 exact lattices, and in none of 300 sets of random sites, before it
/// was made to hold. If it does not hold after kMostCellMoves, the function returns the offsets
/// that it has then.
///
/// Example usage:
///     const std::vector<Offset> images = tied_images(complex, sites.reduction(), chosen);
///
/// @param images  of chosen_images().
/// Cost: O(n) for n cells, and O(n) for each cell that may be moved where something is untied.
std::vector<Offset> tied_images(const CellComplex& complex, const Reduction& reduction,
                                std::vector<Offset> images);

}  // namespace pcvt::space
