#pragma once

#include "mesher/plane/energy/energy.hpp"

namespace pcvt::testing {

/// F, its gradient and the masses in length units, in the plane and in the caller's order of sites.
struct PlaneEnergy {
    double value = 0;
    /// 2 x n.
    plane::Points gradient;
    Eigen::VectorXd mass;
};

/// Converts the result of a pass to the lattice and the order of the caller's sites.
inline PlaneEnergy in_plane(const Energy& energy, const plane::MovingDelaunay& delaunay,
                            const plane::Lattice& lattice) {
    const int n = delaunay.n_sites();
    const double unit = delaunay.unit();
    const plane::Vec2 x = reduce(lattice).reduced.a().stableNormalized();
    const plane::Vec2 y(-x.y(), x.x());
    PlaneEnergy result{energy.value * std::pow(unit, 4), plane::Points(2, n), Eigen::VectorXd(n)};
    for (SiteId s = 0; s < n; ++s) {
        const SiteId id = delaunay.original_id(s);
        const plane::Vec2 g = energy.gradient.segment<2>(2 * s) * std::pow(unit, 3);
        result.gradient.col(id) = g.x() * x + g.y() * y;
        result.mass[id] = energy.mass[s] * unit * unit;
    }
    return result;
}

/// Computes the energy by one pass over a new triangulation.
inline PlaneEnergy energy_at(const plane::Sites& sites, int n_threads = 1) {
    plane::MovingDelaunay delaunay(sites);
    Workers workers(n_threads);
    Energy energy;
    plane::EnergyPass(delaunay, workers).evaluate(energy);
    return in_plane(energy, delaunay, sites.lattice());
}
inline PlaneEnergy energy_at(const plane::Lattice& lattice, const plane::Points& points) {
    return energy_at(plane::Sites(lattice, points));
}

}  // namespace pcvt::testing
