#pragma once

#include "mesher/plane/density/density.hpp"
#include "mesher/plane/geometry/walled_domain.hpp"
#include "mesher/plane/symmetry/plane_group.hpp"

namespace pcvt::plane {

/// The density with the symmetry of a group that equals `density` in one asymmetric unit: each
/// point is evaluated at the image of its orbit with the least u, and of those the least v, in [0,
/// 1)^2. A density that has the symmetry does not change, up to rounding. Under pm it is that of
/// the half v <= 1/2, under pmm that of the quarter u, v <= 1/2.
///
/// Example usage:
///
///     options.density = folded_density(density, PlaneGroup(PlaneGroupName::kPm, lattice));
///
/// Except on hexagonal lattices, integrals are cut at quarters of the periods, where the unit ends,
/// and at the images of the break lines. The cells of the picture of a density become ordinary
/// ones.
Density folded_density(const Density& density, const PlaneGroup& group);

/// The density of a domain between walls in the coordinates of mirrored_lattice(). It is defined
/// between the walls; folded_density() mirrors it.
Density mirrored_density(const Density& density, Walls walls);

/// The image of a point that `folded_density` evaluates: coordinates in the given basis.
Vec2 folded_point(const PlaneGroup& group, const Vec2& u);

}  // namespace pcvt::plane
