#pragma once

#include <vector>

#include "mesher/space/mesh/cell_complex.hpp"

namespace pcvt::space {

/// Returns the corner of the domain of a tile, in coordinates of the reduced basis: the domain is
/// the reduced parallelepiped round the centre of the given one, whose corner lies at `origin`,
/// length units. Where the given basis is reduced up to order and signs, it is the given
/// parallelepiped.
Vec3 domain_corner(const Lattice& lattice, const Reduction& reduction, const Vec3& origin);

/// Chooses one image of each cell: the one whose centroid lies in the half-open domain, and then
/// moves cells by translations until the union is connected across faces. Pieces of cells lie in
/// their box.
///
/// Example usage:
///     const std::vector<Offset> images =
///         chosen_images(complex, cell_bodies(complex), domain_corner(lattice, reduction, origin));
///
/// Law, tested by number:
///   (1) Every cell is joined to cell 0 by a path across faces between chosen images.
///
/// @returns the offset of each cell from its frame in the complex, in the reduced basis.
std::vector<Offset> chosen_images(const CellComplex& complex, const std::vector<CellBody>& bodies,
                                  const Vec3& corner);

}  // namespace pcvt::space
