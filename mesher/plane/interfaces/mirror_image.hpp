#pragma once

#include "mesher/plane/geometry/lattice.hpp"
#include "mesher/torus/walls.hpp"

namespace pcvt::plane {

/// Image r of a point under the reflections at the walls at 0, 0 <= r < n_images(); image 0 is the
/// point itself.
///
/// Example usage:
///   for (int r = 0; r < n_images(walls); ++r) add(mirror_image(p, walls, r));
inline Vec2 mirror_image(Vec2 p, Walls walls, int r) {
    for (int axis = 0; axis < 2; ++axis) {
        if (!has_walls_across(walls, axis)) continue;
        if (r % 2 == 1) p[axis] = -p[axis];
        r /= 2;
    }
    return p;
}

/// Whether mirror_image() r reverses orientations.
constexpr bool is_reflection(int r) { return r == 1 || r == 2; }

}  // namespace pcvt::plane
