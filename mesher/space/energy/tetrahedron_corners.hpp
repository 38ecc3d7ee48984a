#pragma once

#include <span>

#include "mesher/space/energy/facet_heights.hpp"

namespace pcvt::space {

/// Corners 1, 2 and 3 of the tetrahedra of a block relative to corner 0, coordinates of the reduced
/// basis: by corner, axis and tetrahedron.
using CornerRows = std::array<std::array<BlockRow, 3>, 3>;

/// Fills up an incomplete block, from number n on, with tetrahedra that cause no division by zero.
inline void fill_up(CornerRows& corner, int n) {
    for (int k = n; k < kTetrahedraPerBlock; ++k) {
        for (int c = 0; c < 9; ++c) corner[c / 3][c % 3][k] = c / 3 == c % 3 ? 1 : 0;
    }
}

/// Fills in the block of the n tetrahedra from number `first` on.
inline void gather_corners(const TorusTetrahedra& tetrahedra, const Points& coordinates, int first,
                           int n, CornerRows& corner) {
    const SiteId* site = tetrahedra.corner_sites().data() + 4 * std::size_t(first);
    const TetrahedronOffsets* offsets = tetrahedra.corner_offsets().data() + first;
    const double* const u = coordinates.data();
    for (int k = 0; k < n; ++k, site += 4) {
        const double* const origin = u + 3 * std::size_t(site[0]);
        for (int c = 0; c < 3; ++c) {
            const double* const at = u + 3 * std::size_t(site[c + 1]);
            for (int axis = 0; axis < 3; ++axis) corner[c][axis][k] = at[axis] - origin[axis];
        }
        if (offsets[k].all_zero()) continue;
        for (int c = 0; c < 9; ++c) corner[c / 3][c % 3][k] += offsets[k].relative[c];
    }
    fill_up(corner, n);
}

/// Fills in the block of these tetrahedra.
inline void gather_corners(std::span<const Tetrahedron> tetrahedra, const Points& coordinates,
                           CornerRows& corner) {
    for (std::size_t k = 0; k < tetrahedra.size(); ++k) {
        const Vec3 origin = image(coordinates, tetrahedra[k][0]).at;
        for (int c = 0; c < 3; ++c) {
            const Vec3 edge = image(coordinates, tetrahedra[k][c + 1]).at - origin;
            for (int axis = 0; axis < 3; ++axis) corner[c][axis][k] = edge[axis];
        }
    }
    fill_up(corner, static_cast<int>(tetrahedra.size()));
}

}  // namespace pcvt::space
