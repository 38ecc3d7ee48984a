#include "mesher/plane/symmetry/walled_sites.hpp"

#include <string>

#include "mesher/base/error.hpp"
#include "mesher/plane/delaunay/spatial_sort.hpp"

namespace pcvt::plane {
namespace {

void require_between_walls(const Lattice& domain, Walls walls, const Points& points) {
    for (Eigen::Index k = 0; k < points.cols(); ++k) {
        for (int axis = 0; axis < 2; ++axis) {
            if (!has_walls_across(walls, axis)) continue;
            const double at = points(axis, k);
            if (at >= 0 && at <= side_length(domain, axis)) continue;
            throw InvalidInput("site " + std::to_string(k) + " lies beyond a wall: its " +
                               (axis == 0 ? "x" : "y") + " is not between 0 and " +
                               (axis == 0 ? "the width" : "the height"));
        }
    }
}

}  // namespace

SymmetricSites walled_sites(const Lattice& domain, Walls walls, const Points& points) {
    require_between_walls(domain, walls, points);
    const PlaneGroup group(walls == Walls::kXY ? PlaneGroupName::kPmm : PlaneGroupName::kPm,
                           mirrored_lattice(domain, walls),
                           walls == Walls::kX ? MirrorAxis::kAlongB : MirrorAxis::kAlongA);
    const SymmetricSites sites = orbits_of(group, points);
    // Number the points first: the first site of each orbit is the point itself.
    const int n = sites.sites.n_sites();
    std::vector<SiteId> order;
    std::vector<bool> is_point(static_cast<std::size_t>(n), false);
    for (const SiteOrbit& orbit : sites.orbits) {
        order.push_back(orbit.representative);
        is_point[orbit.representative] = true;
    }
    for (SiteId s = 0; s < n; ++s) {
        if (!is_point[s]) order.push_back(s);
    }
    return renumbered(sites, order);
}

Points sorted_by_columns(const Lattice& lattice, const Points& points) {
    const Sites sites(lattice, points);
    const SpatialSort sort = spatial_sort(sites.coordinates(), gram_of(sites.reduction().reduced));
    Points sorted(2, points.cols());
    for (Eigen::Index k = 0; k < points.cols(); ++k) {
        sorted.col(k) = points.col(sort.order[static_cast<std::size_t>(k)]);
    }
    return sorted;
}

}  // namespace pcvt::plane
