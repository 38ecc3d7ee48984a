#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "mesher/base/site_id.hpp"

namespace pcvt::space {

/// The bits of each coordinate that hilbert_index() uses.
inline constexpr int kHilbertBits = 20;

/// The place of a box of the unit cube, cut into 2^20 slices along each axis, on a Hilbert curve:
/// successive boxes share a face, so that points sorted by it are near their successors. The first
/// and the last box are adjacent in the periodic cube.
///
/// Example usage:
///
///     const auto slice = [](double u) { return std::uint32_t(u * (1 << kHilbertBits)); };
///     const std::uint64_t key = hilbert_index({slice(u), slice(v), slice(w)});
std::uint64_t hilbert_index(const std::array<std::uint32_t, 3>& box);

/// The sites in the order in which the curve visits them; by number within one box.
///
/// @param coordinates  3 x n in [0, 1)^3.
std::vector<SiteId> hilbert_order(const Eigen::Matrix3Xd& coordinates);

}  // namespace pcvt::space
