#pragma once

#include "mesher/plane/geometry/sites.hpp"

namespace pcvt::testing {

/// The lattice spanned by (d, -b) / n and (0, a) / n in coordinates of the period vectors, n = a d.
struct SublatticeBasis {
    int a;
    int b;
    int d;
};

/// The n points of one domain, 2 x n.
inline plane::Points sublattice_points(const plane::Lattice& lattice,
                                       const SublatticeBasis& basis) {
    const int n = basis.a * basis.d;
    plane::Points points(2, n);
    for (int k = 0; k < n; ++k) {
        const double i = k / basis.d;
        const double j = k % basis.d;
        points.col(k) =
            lattice.to_position(plane::Vec2(i * basis.d, j * basis.a - i * basis.b) / n);
    }
    return points;
}

inline plane::Sites sublattice_sites(const plane::Lattice& lattice, const SublatticeBasis& basis) {
    return {lattice, sublattice_points(lattice, basis)};
}

}  // namespace pcvt::testing
