#pragma once

#include <Eigen/Core>
#include <vector>

#include "mesher/space/geometry/sites.hpp"

namespace pcvt::testing {

/// The Voronoi cell of a site by brute force, or its power cell: a polyhedron cut by the planes of
/// equal power distance to all images near it, without any triangulation. Length units of the
/// lattice; the site is the origin.
struct ClippedCell {
    /// Convex polygons, each seen counter-clockwise from outside.
    std::vector<std::vector<space::Vec3>> faces;

    double volume() const;
    /// The integral of |p|^2.
    double second_moment() const;
    /// The integral of p.
    space::Vec3 first_moment() const;
};

/// The cells of all sites; cost n^2.
std::vector<ClippedCell> clipped_cells(const space::Sites& sites);

/// The power cells of all sites, those of hidden sites without faces.
/// @param weights  length^2.
std::vector<ClippedCell> clipped_power_cells(const space::Sites& sites,
                                             const Eigen::VectorXd& weights);
/// That of one site.
ClippedCell clipped_power_cell(const space::Sites& sites, const Eigen::VectorXd& weights,
                               SiteId site);

/// The sums over clipped_cells().
struct BruteForceEnergy {
    double value = 0;
    std::vector<double> volumes;
    /// 2 V_i (x_i - g_i), length units.
    std::vector<space::Vec3> gradient;
};

BruteForceEnergy brute_force_energy(const space::Sites& sites);
/// Those over clipped_power_cells().
BruteForceEnergy brute_force_energy(const space::Sites& sites, const Eigen::VectorXd& weights);

}  // namespace pcvt::testing
