#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/bad_file.hpp"
#include "io/run_files/table_name.hpp"

namespace pcvt {

/// The target areas of cells in a table; site s has the s-th row.
///
/// Example usage:
///     const AreaFile file = read_areas(area_table("ebsd.csv:ECD"));
///     require_areas(file, n_sites);
///     const Eigen::VectorXd areas = scaled_areas(file.areas, n_sites, lattice.area());
struct AreaFile {
    /// The file's name in messages.
    std::string name = {};
    /// In any unit: diameters have become areas of circles.
    Eigen::VectorXd areas = {};
    /// The line of each area, counted from 1.
    std::vector<int> lines = {};
    /// The contents for a summary: "diameters of column ECD (um) of ebsd.csv"; the file's name for
    /// a single column of areas without a header, or of diameters under the word `diameter`.
    std::string description = {};
};

/// Reads [area:|diameter:|radius:]FILE[:COLUMN], with volume: in place of area: for volumes.
TableName area_table(const std::string& text);
TableName volume_table(const std::string& text);

/// Reads one area a row, or one equivalent diameter or radius as the header or the prefix says:
/// a table as TableScanner takes it, with the column that find_sizes() finds.
/// @throws BadFile with the line for any other text and for numbers that are not between 1e-150 and
///         1e150.
AreaFile parse_areas(const TableName& name, std::string_view text);
/// The same for volumes: AreaFile::areas are volumes, diameters have become those of balls.
AreaFile parse_volumes(const TableName& name, std::string_view text);

/// Reads the areas, or the volumes, of a regular file.
AreaFile read_areas(const TableName& name);
AreaFile read_volumes(const TableName& name);

/// Requires one area for each site, and that none is below kLeastArea of their mean.
/// @throws BadFile naming the line.
/// @param word  of a size in messages: "area", "volume".
void require_areas(const AreaFile& file, int n_sites, const std::string& word = "area");

}  // namespace pcvt
