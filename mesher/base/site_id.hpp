#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>

namespace pcvt {

/// Sites are numbered from 0 in the order of the input, everywhere.
///
///     for (SiteId s = 0; s < sites.n_sites(); ++s) use(sites.position(s));
using SiteId = std::int32_t;

/// A point further than this many periods from the origin is rejected instead of wrapped.
inline constexpr double kFarthestPeriod = 0x1p30;

/// The first two sites with equal coordinates, by the smaller and the larger id; {-1, -1} if all
/// sites are distinct.
/// @param coordinates  2 x n or 3 x n, wrapped into the domain.
std::pair<SiteId, SiteId> first_equal_sites(const Eigen::Matrix2Xd& coordinates);
std::pair<SiteId, SiteId> first_equal_sites(const Eigen::Matrix3Xd& coordinates);

}  // namespace pcvt
