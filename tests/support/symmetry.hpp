#pragma once

#include <gtest/gtest.h>

#include <map>
#include <utility>

#include "mesher/plane/symmetry/symmetric_sites.hpp"

namespace pcvt::testing {

/// A lattice that the group fits and that is neither turned nor scaled to a special place: an
/// oblique one, a rectangle of 1 : 1.7, a turned square, or a turned hexagonal one.
inline plane::Lattice fitting_lattice(plane::PlaneGroupName name) {
    const plane::Vec2 x(std::cos(0.3), std::sin(0.3));
    const plane::Vec2 y(-x.y(), x.x());
    switch (plane_group_row(name).system) {
        case plane::LatticeSystem::kOblique:
            return {plane::Vec2(1, 0), plane::Vec2(0.37, 0.81)};
        case plane::LatticeSystem::kRectangular:
            return plane::Lattice::rectangle(1, 1.7);
        case plane::LatticeSystem::kSquare:
            return {2 * x, 2 * y};
        case plane::LatticeSystem::kHexagonal:
            return {3 * x, 1.5 * x + 3 * std::sqrt(0.75) * y};
    }
    return plane::Lattice::rectangle(1, 1);
}

inline std::pair<double, double> key(const plane::Vec2& u) {
    return {plane::wrap(u.x()).fraction, plane::wrap(u.y()).fraction};
}

/// Expects that each operation maps each site exactly to a site of its orbit, up to one unit of the
/// grid at centres with coordinates in thirds.
/// @param start  the orbits; `sites` are where they are now.
inline void expect_symmetric(const plane::SymmetricSites& start, const plane::Sites& sites) {
    std::map<std::pair<double, double>, SiteId> at;
    for (SiteId s = 0; s < sites.n_sites(); ++s) at[key(sites.coordinates().col(s))] = s;
    int n_missing = 0;
    for (const plane::LatticeIsometry& g : start.group.operations()) {
        for (SiteId s = 0; s < sites.n_sites(); ++s) {
            const plane::Vec2 u = g(sites.coordinates().col(s));
            const bool is_centre = start.orbits[start.orbit[s]].freedom == 0;
            bool found = false;
            for (int i = is_centre ? -1 : 0; i <= (is_centre ? 1 : 0); ++i) {
                for (int j = is_centre ? -1 : 0; j <= (is_centre ? 1 : 0); ++j) {
                    const auto image = at.find(key(u + plane::Vec2(i, j) * 0x1p-51));
                    found |= image != at.end() && start.orbit[image->second] == start.orbit[s];
                }
            }
            n_missing += !found;
        }
    }
    EXPECT_EQ(n_missing, 0) << start.group.row().word << ", " << sites.n_sites() << " sites";
}

}  // namespace pcvt::testing
