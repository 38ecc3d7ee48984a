#pragma once

#include "mesher/plane/geometry/walled_domain.hpp"
#include "mesher/plane/symmetry/symmetric_sites.hpp"

namespace pcvt::plane {

/// Sites between walls together with their mirror images, which make the walls edges of cells: the
/// sites with the symmetry pm, between four walls pmm, of the torus with mirrored_lattice().
///
/// Example usage:
///
///     const SymmetricSites start = walled_sites(Lattice::rectangle(4, 1), Walls::kY, points);
///     const CvtResult cvt = compute_cvt(start, {});  // sites 0 ... n - 1 lie between the walls
///
/// Site k is point k; the images have higher ids. A point on a wall, within kSameVertex h, moves
/// along it only and is its own image.
/// @param domain  upright.
/// @param points  2 x n in the domain, length units; along the periodic direction anywhere.
/// @throws InvalidInput  naming the first point that lies beyond a wall.
/// @throws DuplicateSites if two points coincide.
SymmetricSites walled_sites(const Lattice& domain, Walls walls, const Points& points);

/// The points in the order of their columns (spatial_sort.hpp).
Points sorted_by_columns(const Lattice& lattice, const Points& points);

}  // namespace pcvt::plane
