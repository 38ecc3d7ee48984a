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
    /// Keys of runs with the box outline alone, in units of h, and of runs with grains alone.
    std::optional<double> box_shortest_edge = {};
    std::optional<Grains> grains = {};
};

/// The report as JSON: one key a line, numbers as the shortest decimals that read back, text as
/// UTF-8 (bytes that are not become U+FFFD).
/// @throws InternalError if a number is not finite.
std::string encode_report(const Report& report);

}  // namespace pcvt
