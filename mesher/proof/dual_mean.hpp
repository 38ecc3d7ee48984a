#pragma once

#include <optional>
#include <span>

#include "mesher/lattice/lattice.hpp"

namespace pcvt {

/// A site with its weight, length^2.
struct DualSite {
    Vec2 point;
    double weight = 0;
};

struct DualMean {
    Vec2 point;
    /// How far rounding of the sites may move the point, length units.
    double error = 0;
};

/// Returns the mean of the Voronoi vertices of the k - 2 Delaunay triangles into which the polygon
/// of k sites falls: where the corner lies that a group of Voronoi vertices between these sites was
/// joined to. For k = 3 this is the Voronoi vertex. With weights, vertices are those of the power
/// diagram (the triangles are regular ones).
///
/// Example usage:
///   const auto corner = dual_mean(sites_round_a_corner, 1e-16);
///   const double off = corner ? (corner->point - p).norm() : infinity;
///
/// @param polygon   at least three sites, counter-clockwise; need not be convex.
/// @param rounding  the error of a coordinate of a site, length units.
/// @returns nothing if the polygon cannot be divided.
std::optional<DualMean> dual_mean(std::span<const DualSite> polygon, double rounding);

}  // namespace pcvt
