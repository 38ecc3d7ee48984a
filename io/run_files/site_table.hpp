#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/run_files/phase_reader.hpp"
#include "io/run_files/site_reader.hpp"
#include "io/run_files/weight_reader.hpp"
#include "mesher/cells/cell_materials.hpp"

namespace pcvt {

/// The columns of the coordinates: "x,y", or "x,y,z" in space.
inline const char* names_of_coordinates(int dimension) { return dimension == 3 ? "x,y,z" : "x,y"; }

/// Which quantities of a table of sites count; without one of them, its column may hold anything.
struct SiteColumns {
    bool weights = true;
    bool phases = true;
    bool orientations = true;
};

/// The sites of a table, and the quantities of each that its header names beside the coordinates:
/// so that a table of cells (cell_writer.hpp) gives the same cells again.
///
/// Example usage:
///     const SiteTable<2> table = read_site_table<2>(parse_table_name("cells.csv"), {});
///     if (table.weights) job.weights = {table.weights->weights, table.weights->description};
template <int Dimension>
struct SiteTable {
    SiteFileOf<Dimension> sites;
    /// The column `weight`.
    std::optional<WeightFile> weights = {};
    /// The column `phase`.
    std::optional<PhaseFile> phases = {};
    /// The columns phi1, Phi and phi2.
    std::vector<BungeAngles> orientations = {};
};

/// Reads the sites as parse_sites() does. Without names of columns, takes the other quantities as
/// well, each if a row has it; all rows must have it then.
/// @throws BadFile as parse_sites(), parse_weights(), parse_phase_table() and parse_orientations()
///         do.
template <int Dimension>
SiteTable<Dimension> parse_site_table(const TableName& name, std::string_view text,
                                      const SiteColumns& wanted);

/// Reads the table of a file, or of standard input if the path is "-".
template <int Dimension>
SiteTable<Dimension> read_site_table(const TableName& name, const SiteColumns& wanted);

}  // namespace pcvt
