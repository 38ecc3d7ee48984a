#pragma once

#include "tests/support/space_lattices.hpp"

namespace pcvt::testing {

struct NamedSpaceSites {
    std::string name;
    space::Sites sites;
};

/// The points u_0 a + u_1 b + u_2 c.
inline space::Points in_lattice(const space::Lattice& lattice, const space::Points& coordinates) {
    space::Points points(3, coordinates.cols());
    for (Eigen::Index s = 0; s < points.cols(); ++s) {
        points.col(s) = lattice.to_position(coordinates.col(s));
    }
    return points;
}

/// Points of the unit cube in exact rows, planes and grids, on a sphere, in a cluster.
inline std::vector<std::pair<std::string, space::Points>> special_coordinates(std::uint64_t seed) {
    const space::Lattice cube = space::Lattice::box(1, 1, 1);
    std::vector<std::pair<std::string, space::Points>> all;
    space::Points row = uniform_points(cube, 9, seed);
    row.topRows(2).setConstant(0.25);
    all.emplace_back("row", row);
    space::Points plane = uniform_points(cube, 16, seed);
    plane.row(1).setConstant(0.125);
    all.emplace_back("plane", plane);
    space::Points planes = uniform_points(cube, 16, seed);
    planes.row(2) = (planes.row(2).array() * 4).floor().matrix() / 4;
    all.emplace_back("planes", planes);
    space::Points grid = uniform_points(cube, 24, seed);
    grid = (grid * 8).array().floor().matrix() / 8;
    space::Points distinct(3, 0);
    for (Eigen::Index s = 0; s < grid.cols(); ++s) {
        bool known = false;
        for (Eigen::Index t = 0; t < distinct.cols(); ++t) known |= distinct.col(t) == grid.col(s);
        if (known) continue;
        distinct.conservativeResize(3, distinct.cols() + 1);
        distinct.rightCols(1) = grid.col(s);
    }
    all.emplace_back("some points of a grid", distinct);
    // All integer points at distance 3 from the origin.
    space::Points sphere(3, 30);
    int n = 0;
    for (int o = 0; o < 343; ++o) {
        const space::Vec3 p(o / 49 - 3, o / 7 % 7 - 3, o % 7 - 3);
        if (p.squaredNorm() == 9) sphere.col(n++) = (p + space::Vec3(4, 4, 4)) / 8;
    }
    all.emplace_back("sphere", sphere);
    all.emplace_back("cluster", uniform_points(cube, 24, seed) / 64);
    for (const int m : {1, 2}) {
        const auto size = std::to_string(m);
        all.emplace_back("simple cubic " + size, cubic_points(Cubic::kSimple, m));
        all.emplace_back("body-centred " + size, cubic_points(Cubic::kBodyCentred, m));
        all.emplace_back("face-centred " + size, cubic_points(Cubic::kFaceCentred, m));
    }
    return all;
}

/// Random sites on all kinds of lattices and special sites on some of them, n small enough for slow
/// tests.
inline std::vector<NamedSpaceSites> space_site_families(std::uint64_t seed) {
    std::vector<NamedSpaceSites> all;
    for (const auto& [name, lattice] : space_lattices()) {
        for (const int n : {1, 2, 3, 4, 5, 6, 7, 8, 23}) {
            all.push_back({name + " with " + std::to_string(n),
                           space::Sites(lattice, uniform_points(lattice, n, seed + n))});
        }
        if (name != "cube" && name != "needle" && name != "oblique") continue;
        for (const auto& [kind, u] : special_coordinates(seed)) {
            all.push_back({name + " with " + kind, space::Sites(lattice, in_lattice(lattice, u))});
        }
    }
    return all;
}

}  // namespace pcvt::testing
