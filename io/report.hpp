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
};

/// The report as JSON: one key a line, numbers as the shortest decimals that read back, text as
/// UTF-8 (bytes that are not become U+FFFD).
/// @throws InternalError if a number is not finite.
std::string encode_report(const Report& report);

}  // namespace pcvt
