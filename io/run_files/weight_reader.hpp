#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/bad_file.hpp"
#include "io/run_files/table_name.hpp"

namespace pcvt {

/// The weights of sites in a table; site s has the s-th row.
///
/// Example usage:
///     const WeightFile file = read_weights(weight_table("spheres.csv:radius"));
///     require_weights(file, n_sites);
struct WeightFile {
    /// The file's name in messages.
    std::string name = {};
    /// In the unit of the sites, squared; radii have become squares.
    Eigen::VectorXd weights = {};
    /// The line of each weight, counted from 1.
    std::vector<int> lines = {};
    /// The unit of radii or diameters that the header states; empty without one, and for weights.
    std::string unit = {};
    /// The line of the header; 0 without one.
    int header_line = 0;
    /// The contents for a summary: "squared radii of column R (um) of spheres.csv".
    std::string description = {};
};

/// Reads [weight:|radius:|diameter:]FILE[:COLUMN].
TableName weight_table(const std::string& text);

/// Reads one weight a row, or one radius or diameter as the header or the prefix says: a table as
/// TableScanner takes it. The column is the one that is named; else in a header the column
/// `weight`, or the only one of radii or diameters; else the only one.
/// @throws BadFile with the line for any other text, and for a radius that is negative or not below
///         1e150.
WeightFile parse_weights(const TableName& name, std::string_view text);

/// Reads the weights of a regular file.
WeightFile read_weights(const TableName& name);

/// Requires one weight for each site.
/// @throws BadFile naming the line.
void require_weights(const WeightFile& file, int n_sites);

}  // namespace pcvt
