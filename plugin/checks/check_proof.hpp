#pragma once

#include <functional>
#include <optional>
#include <string>

#include "io/run_files/area_reader.hpp"
#include "io/run_files/inclusion_reader.hpp"
#include "mesher/plane/density/density.hpp"
#include "mesher/plane/geometry/lattice.hpp"

namespace pcvt::checks {

/// The density for the lattice of a file, in which it has the coordinates u and v.
using DensityOfLattice = std::function<plane::Density(const plane::Lattice& lattice)>;

/// The properties that a file must have.
struct Question {
    /// The lattice of files that state none; a stated one must be equal.
    std::optional<plane::Lattice> lattice = {};
    /// In units of h; `nullopt`: the Voronoi property is not checked.
    std::optional<double> cvt_tolerance = {};
    std::optional<AreaFile> areas = {};
    /// For cells in space.
    std::optional<AreaFile> volumes = {};
    /// The shapes inside or outside of which each cell must lie.
    std::optional<InclusionFile> inclusions = {};
    /// The tolerance of positions, length units; 0: the precision of each file.
    double tolerance = 0;
    /// The density of the centroids; empty: rho = 1.
    DensityOfLattice density = {};
};

/// Proves one file. Returns a line that states the proved properties.
///
/// Example usage:
///     std::string line = prove("tile.obj", {.cvt_tolerance = 1e-5});
///
/// @throws NotATile      where the file is refuted; the message begins with the path and names what
///                       the file should hold.
/// @throws UnusableFile  where it cannot be read, or cannot have a property.
/// @throws BadFile       where its contents are not what its format demands.
/// @throws InvalidInput  of the density.
std::string prove(const std::string& path, const Question& question);

}  // namespace pcvt::checks
