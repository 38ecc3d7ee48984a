#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mesher/lattice/lattice.hpp"

namespace pcvt {

/// What a run tells about itself, in the order of the file's keys.
struct Report {
    struct Seconds {
        double build;
        double optimize;
        double write;
        double total;
    };

    /// The best exact lattice for the number of sites.
    struct Pattern {
        Lattice basis;
        /// a, b, d: it is spanned by (d, -b) / n and (0, a) / n in the reduced period vectors.
        std::array<int, 3> hermite;
        double energy;
        /// Whether it is a minimum: yes, no, unknown.
        std::string minimum;
        /// Of the Hessian, over the largest; null for one site.
        std::optional<double> smallest_eigenvalue;
    };
    /// A corner of a cell that is too sharp for the angles of grains.
    struct SharpCorner {
        int site;
        Vec2 point;
        double angle;
    };
    struct Grains {
        int triangles;
        /// Degrees, of all angles but those in the sharp corners.
        double smallest_angle;
        std::vector<SharpCorner> sharp_corners;
    };
    /// Of runs with a density.
    struct Density {
        /// The formula or the file.
        std::string name;
        /// Extremes wherever it was asked.
        double least;
        double greatest;
        /// In one evaluation of the energy.
        double evaluations_per_site;
        /// Density x length^2, and its relative difference from the integral without cells.
        double mass;
        double mass_deviation;
        /// What the energy tends to for many sites, density x length^4.
        double expected_energy;
        /// Median of |h_i / l_i - 1| over the cells, l_i by rho^(-1/4).
        double spacing_deviation;
        /// Of a centroid, in spacings of its cell.
        double quadrature_error;
        int rough_cells;
    };

    std::string version;
    int sites;
    Lattice lattice;
    std::uint64_t seed;
    std::string solver;
    std::string start;
    std::string stop;
    int iterations;
    int evaluations;
    /// Of Newton's method; not counted among the evaluations.
    int hessians;
    int cg_products;
    double energy;
    /// null where the density is not uniform.
    std::optional<double> energy_bound;
    double residual;
    /// yes, no or unknown; null where it was not asked.
    std::optional<std::string> minimum;
    int hexagons;
    /// Number of sides of a cell -> how many cells have it.
    std::map<int, int> valences;
    /// null unless the mirror method ran.
    std::optional<int> mirrors;
    int threads;
    Seconds seconds;
    std::vector<std::string> files;
    /// How a global search found the sites, in words. This key and the next one are left out where
    /// they are empty.
    std::string found = {};
    std::optional<Pattern> pattern = {};
    /// Keys of runs with the box outline alone, in units of h, and of runs with grains alone.
    std::optional<double> box_shortest_edge = {};
    std::optional<Grains> grains = {};
    /// Its keys are left out where there is none.
    std::optional<Density> density = {};
};

/// The report as JSON: one key a line, numbers as the shortest decimals that read back, text as
/// UTF-8 (bytes that are not become U+FFFD).
/// @throws InternalError if a number is not finite.
std::string encode_report(const Report& report);

}  // namespace pcvt
