#pragma once

#include <limits>

#include "mesher/plane/geometry/sites.hpp"

namespace pcvt::testing {

/// The squared torus distance of a point to the nearest image of one site, from 7 x 7 images.
inline double squared_distance(const plane::Sites& sites, SiteId site, const plane::Vec2& p) {
    const plane::Lattice& reduced = sites.reduction().reduced;
    const plane::Vec2 u = reduced.to_lattice(p);
    const plane::Offset near{plane::wrap(u.x()).whole, plane::wrap(u.y()).whole};
    double least = std::numeric_limits<double>::infinity();
    for (int i = -3; i <= 3; ++i) {
        for (int j = -3; j <= 3; ++j) {
            const plane::Vec2 image =
                sites.position(site) + reduced.translation(near + plane::Offset{i, j});
            least = std::min(least, (image - p).squaredNorm());
        }
    }
    return least;
}

/// The squared torus distance of a point to the nearest of all sites.
inline double squared_distance(const plane::Sites& sites, const plane::Vec2& p) {
    double least = std::numeric_limits<double>::infinity();
    for (SiteId s = 0; s < sites.n_sites(); ++s) {
        least = std::min(least, squared_distance(sites, s, p));
    }
    return least;
}

}  // namespace pcvt::testing
