#pragma once

#include <Eigen/Core>

#include "mesher/plane/proof/validate.hpp"

namespace pcvt::plane {

/// Proves that each face of a tile of whole cells is the power cell of its site among all images of
/// all sites: the points p with the least |p - x_i|^2 - w_i.
///
/// Every cell must be convex, every edge must lie on the line of equal power distance of the two
/// sites, and each cell on its own side of it. The power distance is then a convex function over
/// the plane, cell by cell, so that the local laws imply the global property. A power cell lies in
/// the Voronoi cell of its site among only the images of that site; so the image of the site that
/// belongs to a face is the nearest to the centroid.
///
/// Example usage:
///   const double distance = prove_power_cells(tile, proof, points, weights, 1e-9);
///
/// @param proof      the result of prove_tile for this tile.
/// @param points     2 x n, any image of each site, length units; site s is the site of the face
///                   with face_site s.
/// @param weights    n, length^2.
/// @param tolerance  the largest distance of a corner from the line on which it should lie, in
///                   units of h = sqrt(area / n).
/// @returns the largest such distance found, in units of h.
/// @throws NotATile naming the face and the amount.
/// @throws InvalidInput unless the tile has one whole cell for each site.
double prove_power_cells(const Tile& tile, const TileProof& proof, const Points& points,
                         const Eigen::VectorXd& weights, double tolerance);

}  // namespace pcvt::plane
