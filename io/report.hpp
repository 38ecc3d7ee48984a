#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mesher/lattice.hpp"

namespace pcvt {

/// What a run tells about itself, in the order of the file's keys.
struct Report {
    struct Seconds {
        double build;
        double optimize;
        double write;
        double total;
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
    double energy;
    /// null where the density is not uniform.
    std::optional<double> energy_bound;
    double residual;
    int hexagons;
    /// Number of sides of a cell -> how many cells have it.
    std::map<int, int> valences;
    /// null unless the mirror method ran.
    std::optional<int> mirrors;
    int threads;
    Seconds seconds;
    std::vector<std::string> files;
    /// Its keys are left out where there is none.
    std::optional<Density> density = {};
};

/// The report as JSON: one key a line, numbers as the shortest decimals that read back, text as
/// UTF-8 (bytes that are not become U+FFFD).
/// @throws InternalError if a number is not finite.
std::string encode_report(const Report& report);

}  // namespace pcvt
