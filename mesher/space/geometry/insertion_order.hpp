#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "mesher/base/site_id.hpp"

namespace pcvt::space {

/// Chooses the site nearest to the middle of each box of a grid; boxes without sites have none.
///
/// @param coordinates  3 x n in [0, 1)^3.
std::vector<SiteId> spread_sample(const Eigen::Matrix3Xd& coordinates,
                                  const std::array<int, 3>& n_boxes);

/// An order of all sites for an incremental triangulation: the given first ones, then rounds of
/// random sites. Each round has eight times as many sites as the one before, so that a new site
/// changes few tetrahedra, and is sorted along a Hilbert curve, so that a new site is near the one
/// before it.
///
/// Example usage:
///
///     const std::vector<SiteId> first = spread_sample(coordinates, {5, 5, 5});
///     for (const SiteId s : insertion_order(coordinates, first)) insert(s);
///
/// @param coordinates  3 x n in [0, 1)^3.
std::vector<SiteId> insertion_order(const Eigen::Matrix3Xd& coordinates,
                                    const std::vector<SiteId>& first);

}  // namespace pcvt::space
