#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "mesher/cells/empty_cells.hpp"
#include "mesher/space/cvt/cvt.hpp"
#include "mesher/space/cvt/weighted_cells.hpp"
#include "mesher/space/mesh/cell_complex.hpp"
#include "tests/support/polyhedra.hpp"
#include "tests/support/random_numbers.hpp"

namespace pcvt::testing {

/// Cells that are filled with tetrahedra in tests and measurements.
struct GrainCase {
    space::Sites sites;
    space::CellComplex complex;
};

/// The words that grain_case() takes.
inline const std::vector<std::string>& grain_kinds() {
    static const std::vector<std::string> kinds{"cvt",     "random",  "power",   "grid",  "lattice",
                                                "shifted", "cluster", "oblique", "plate", "rod"};
    return kinds;
}

/// Voronoi cells of points.
inline GrainCase voronoi_case(const space::Lattice& lattice, const space::Points& points) {
    const space::PeriodicDelaunay delaunay =
        space::periodic_delaunay(space::Sites(lattice, points));
    return {delaunay.sites, cell_complex(delaunay.sites, delaunay.tetrahedra)};
}

/// Cells of a converged tessellation.
inline GrainCase centroidal_case(int n, std::uint64_t seed) {
    const space::Lattice cube = space::Lattice::box(1, 1, 1);
    space::CvtOptions options;
    options.run.tolerance = 1e-3;
    const space::CvtResult cells = compute_cvt(cube, uniform_points(cube, n, seed), options);
    return {cells.delaunay.sites, cell_complex(cells.delaunay.sites, cells.delaunay.tetrahedra)};
}

/// Power cells of random sites: the largest weights for which no cell is empty, of a series.
inline GrainCase power_case(int n, std::uint64_t seed) {
    const space::Lattice cube = space::Lattice::box(1, 1, 1);
    const space::Points points = uniform_points(cube, n, seed);
    std::mt19937_64 random(seed);
    Eigen::VectorXd weights(n);
    for (double& w : weights) w = random_number(random) * std::pow(n, -2.0 / 3);
    for (;; weights /= 1.5) {
        try {
            const space::WeightedCells cells = space::weighted_cells(cube, points, weights, {});
            return {cells.delaunay.sites,
                    cell_complex(cells.delaunay.sites, cells.delaunay.tetrahedra,
                                 cells.delaunay.weights)};
        } catch (const EmptyCells&) {
        }
    }
}

/// Points of a cubic, a face-centred or a body-centred lattice, each moved by about 10^-d of the
/// spacing, d = 2 ... 6, so that vertices of four cells fall apart into short edges.
inline space::Points shifted_points(int k, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const int kind = random_integer(random, 0, 2);
    const double way = std::pow(10, -random_integer(random, 2, 6)) / k;
    std::vector<space::Vec3> basis{{0, 0, 0}};
    if (kind == 1) basis = {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}};
    if (kind == 2) basis = {{0, 0, 0}, {0.5, 0.5, 0.5}};
    space::Points points(3, static_cast<Eigen::Index>(basis.size()) * k * k * k);
    Eigen::Index column = 0;
    for (int cube = 0; cube < k * k * k; ++cube) {
        for (const space::Vec3& b : basis) {
            const space::Vec3 corner(cube % k, cube / k % k, cube / k / k);
            const space::Vec3 arm(random_number(random), random_number(random),
                                  random_number(random));
            points.col(column++) = (corner + b) / k + way * arm;
        }
    }
    return points;
}

/// Half of the sites in a ball of a tenth of the period.
inline space::Points cluster_points(int n, std::uint64_t seed) {
    space::Points points = uniform_points(space::Lattice::box(1, 1, 1), n, seed);
    for (int k = 0; k < n / 2; ++k) points.col(k) = points.col(k) * 0.1;
    return points;
}

/// @param n  the number of sites; that of kinds with a pattern is near to it.
inline GrainCase grain_case(const std::string& kind, int n, std::uint64_t seed) {
    using space::Lattice;
    const Lattice cube = Lattice::box(1, 1, 1);
    const int k = std::max(1, static_cast<int>(std::lround(std::cbrt(n))));
    if (kind == "cvt") return centroidal_case(n, seed);
    if (kind == "power") return power_case(n, seed);
    if (kind == "grid") return voronoi_case(cube, grid_points(k));
    if (kind == "lattice") return voronoi_case(cube, lattice_points(n));
    if (kind == "shifted") return voronoi_case(cube, shifted_points(k, seed));
    if (kind == "cluster") return voronoi_case(cube, cluster_points(n, seed));
    const auto random = [&](const Lattice& lattice) {
        return voronoi_case(lattice, uniform_points(lattice, n, seed));
    };
    if (kind == "oblique") {
        return random(Lattice({1, 0.2, 0.1}, {-0.3, 0.9, 0.2}, {2.4, 0.3, 1.2}));
    }
    if (kind == "plate") return random(Lattice::box(1, 1, 0.01));
    if (kind == "rod") return random(Lattice::box(1, 0.01, 0.01));
    return random(cube);
}

}  // namespace pcvt::testing
