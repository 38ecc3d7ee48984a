#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "mesher/plane/geometry/sites.hpp"

namespace pcvt::testing {

struct NamedSites {
    std::string name;
    plane::Sites sites;
};

/// columns x rows sites on a grid of the lattice, the first at lattice coordinates (u, v).
inline plane::Sites grid_sites(const plane::Lattice& lattice, int columns, int rows, double u,
                               double v) {
    plane::Points points(2, columns * rows);
    for (int k = 0; k < columns * rows; ++k) {
        points.col(k) = lattice.to_position(
            {u + double(k % columns) / columns, v + double(k / columns) / rows});
    }
    return {lattice, points};
}

/// n sites on one straight line along `direction`.
inline plane::Sites sites_on_a_line(const plane::Lattice& lattice, int n,
                                    const plane::Vec2& direction) {
    plane::Points points(2, n);
    for (int k = 0; k < n; ++k) points.col(k) = (k + 0.5) / n * direction;
    return {lattice, points};
}

/// Sites with exact ties, with near ties, and on the seam.
inline std::vector<NamedSites> special_sites() {
    const plane::Lattice unit = plane::Lattice::rectangle(1, 1);
    const plane::Lattice turned({std::cos(0.3), std::sin(0.3)}, {-std::sin(0.3), std::cos(0.3)});
    const plane::Lattice hexagonal({1, 0}, {0.5, std::sqrt(0.75)});
    std::vector<NamedSites> list;
    for (const int n : {1, 2, 3, 4, 5, 8}) {
        const std::string size = std::to_string(n);
        list.push_back({"grid on the seam " + size, grid_sites(unit, n, n, 0, 0)});
        list.push_back({"grid " + size, grid_sites(unit, n, n, 0.5 / n, 0.5 / n)});
        list.push_back({"grid of thirds " + size, grid_sites(unit, n, n, 1.0 / 3, 0.1)});
        list.push_back({"turned grid " + size, grid_sites(turned, n, n, 0, 0)});
        list.push_back({"hexagons " + size, grid_sites(hexagonal, n, n, 0, 0)});
        list.push_back({"uneven grid " + size, grid_sites(unit, n, 2 * n + 1, 0, 0)});
        list.push_back({"row " + size, sites_on_a_line(unit, n, {1, 0})});
        list.push_back({"diagonal " + size, sites_on_a_line(unit, n, {1, 1})});
        list.push_back(
            {"thin row " + size, sites_on_a_line(plane::Lattice::rectangle(20, 1), n, {20, 0})});
    }
    return list;
}

}  // namespace pcvt::testing
