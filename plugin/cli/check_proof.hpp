#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/run_files/area_reader.hpp"
#include "io/run_files/inclusion_reader.hpp"
#include "mesher/plane/geometry/lattice.hpp"

namespace pcvt::cli {

/// The options of a density as they were typed, which wait for the lattice of each file.
struct TypedDensity {
    /// Empty: rho = 1.
    std::string formula = {};
    std::string range = {};
};

/// The files to check, and the properties that each must have.
struct Question {
    std::vector<std::string> files;
    /// The lattice of files that state none; a stated one must be equal.
    std::optional<plane::Lattice> lattice;
    /// In units of h; `nullopt`: the Voronoi property is not checked.
    std::optional<double> cvt_tolerance;
    std::optional<AreaFile> areas = {};
    /// The shapes inside or outside of which each cell must lie.
    std::optional<InclusionFile> inclusions = {};
    /// The tolerance of positions, length units; 0: the precision of each file.
    double tolerance = 0;
    TypedDensity density = {};
};

/// Proves one file. Returns a line that states the proved properties.
///
/// Example usage:
///     print(prove("tile.obj", {.files = {}, .lattice = {}, .cvt_tolerance = 1e-5}));
///
/// @throws NotATile      where the file is refuted; the message begins with the path and names what
///                       the file should hold.
/// @throws InvalidInput  where it cannot be read, or lacks a property.
std::string prove(const std::string& path, const Question& question);

}  // namespace pcvt::cli
