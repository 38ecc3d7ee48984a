#pragma once

#include "mesher/energy/energy.hpp"

namespace pcvt::testing {

/// F, its gradient and the masses in length units, in the plane and in the caller's order of sites.
struct PlaneEnergy {
    double value = 0;
    /// 2 x n.
    Points gradient;
    Eigen::VectorXd mass;
};

/// Converts the result of a pass to the lattice and the order of the caller's sites.
inline PlaneEnergy in_plane(const Energy& energy, const MovingDelaunay& delaunay,
                            const Lattice& lattice) {
    const int n = delaunay.n_sites();
    const double unit = delaunay.unit();
    const Vec2 x = reduce(lattice).reduced.a().stableNormalized();
    const Vec2 y(-x.y(), x.x());
    PlaneEnergy told{energy.value * std::pow(unit, 4), Points(2, n), Eigen::VectorXd(n)};
    for (SiteId s = 0; s < n; ++s) {
        const SiteId id = delaunay.original_id(s);
        const Vec2 g = energy.gradient.segment<2>(2 * s) * std::pow(unit, 3);
        told.gradient.col(id) = g.x() * x + g.y() * y;
        told.mass[id] = energy.mass[s] * unit * unit;
    }
    return told;
}

/// Computes the energy by one pass over a new triangulation.
inline PlaneEnergy energy_at(const Sites& sites, int n_threads = 1) {
    MovingDelaunay delaunay(sites);
    Workers workers(n_threads);
    Energy energy;
    EnergyPass(delaunay, workers).evaluate(energy);
    return in_plane(energy, delaunay, sites.lattice());
}
inline PlaneEnergy energy_at(const Lattice& lattice, const Points& points) {
    return energy_at(Sites(lattice, points));
}

}  // namespace pcvt::testing
