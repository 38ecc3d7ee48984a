#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/run_files/area_reader.hpp"
#include "mesher/lattice/lattice.hpp"

namespace pcvt::cli {

/// What is asked of every file.
struct Question {
    std::vector<std::string> files;
    /// For files that state none; what a file states must be this.
    std::optional<Lattice> lattice;
    /// In units of h; nothing: the Voronoi property is not asked for.
    std::optional<double> cvt_tolerance;
    std::optional<AreaFile> areas = {};
    /// As typed; empty: rho = 1.
    std::string density = {};
    std::string density_range = {};
};

/// Proves one file, and returns what was proved as a line.
///
/// Example usage:
///     print(prove("tile.obj", {.files = {}, .lattice = {}, .cvt_tolerance = 1e-5}));
///
/// @throws NotATile      where the file is refuted.
/// @throws InvalidInput  where it cannot be read, or does not hold what is asked of it.
std::string prove(const std::string& path, const Question& question);

/// The thing that a file should hold: "a periodic tile".
const char* content_of(const std::string& path);

}  // namespace pcvt::cli
