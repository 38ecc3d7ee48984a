#pragma once

#include <string>
#include <vector>

#include "plugin/browser/run.hpp"

namespace pcvt::browser {

/// Reads the tables of a run into its options, as the command reads --input, --areas and --weights,
/// with the same messages. The other options of the run are complete.
///
///     if (const pcvt_status status = read_tables(*run); status != PCVT_OK) return status;
///
/// @returns PCVT_OK, or the status of an error, which pcvt_last_error() then explains.
pcvt_status read_tables(Run& run);

/// Puts the line of the table of sites into the last error, where it concerns one of the sites:
/// coincident sites, and cells that are empty.
/// @param status  of the run that failed.
void name_lines(const Run& run, pcvt_status status);

/// The use of a table: sites or sizes.
enum class TableUse { kGuessed = 0, kSites = 1, kSizes = 2 };

/// The contents of a table, for a page that shows it before a run.
struct TableContents {
    /// Lines: the use (sites or sizes), the number of rows, the name for --input or --areas, the
    /// quantity (sites, areas, diameters or radii), the columns with tabs, and their unit. The
    /// name of sites with weights, phases or orientations names the columns of the positions, so
    /// that only these count.
    std::string lines = {};
    /// x, y, x, y, ... of sites; else empty.
    std::vector<double> points = {};
};

/// Reads a whole table, as a run will. Without a use, columns x and y of a header are sites, else a
/// column of areas, diameters or radii holds sizes; without a header, two columns are sites, and
/// one holds sizes.
/// @returns PCVT_OK, or the status of an error, with the message of the reader of sites or sizes;
///          also for a header with neither, and for a row "1,5" that may be one number or two.
pcvt_status look_at_table(const std::string& text, TableUse use, TableContents& contents);

}  // namespace pcvt::browser
