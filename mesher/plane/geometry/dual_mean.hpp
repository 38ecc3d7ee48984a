#pragma once

#include <optional>
#include <span>

#include "mesher/plane/geometry/lattice.hpp"

namespace pcvt::plane {

/// A site with its weight, length^2.
struct DualSite {
    Vec2 point;
    double weight = 0;
};

struct DualMean {
    Vec2 point;
    /// The largest distance by which rounding of the sites moves the point, length units.
    double error = 0;
    /// The largest distance of one of the Voronoi vertices from the point, length units.
    double spread = 0;
};

/// Returns the mean of the Voronoi vertices of the k - 2 Delaunay triangles that divide the polygon
/// of k sites: the position of a corner to which these Voronoi vertices were joined. For k = 3 this
/// is the Voronoi vertex. With weights, the triangles are regular, and the vertices are those of
/// the power diagram.
///
/// Example usage:
///   const auto corner = dual_mean(sites_round_a_corner, 1e-16);
///   const double off = corner ? (corner->point - p).norm() : infinity;
///
/// @param polygon   at least three sites, counter-clockwise; need not be convex.
/// @param rounding  the error of a coordinate of a site, length units.
/// @returns nullopt if the polygon cannot be divided.
std::optional<DualMean> dual_mean(std::span<const DualSite> polygon, double rounding);

}  // namespace pcvt::plane
