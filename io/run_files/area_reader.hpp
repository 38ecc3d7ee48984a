#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/bad_file.hpp"

namespace pcvt {

/// The target areas of cells in a text file; site s has the s-th line that holds a number.
///
/// Example usage:
///     const AreaFile file = read_areas("grains.txt");
///     require_areas(file, n_sites);
///     const Eigen::VectorXd areas = scaled_areas(file.areas, n_sites, lattice.area());
struct AreaFile {
    /// The file's name in messages.
    std::string name;
    /// In any unit: diameters have become areas of circles.
    Eigen::VectorXd areas;
    /// The line of each area, counted from 1.
    std::vector<int> lines;
};

/// Reads one area per line or, below a line with the word `diameter`, one equivalent diameter.
/// Accepts blank lines, comments after a #, CRLF, a byte order mark and tabs.
/// @throws BadFile with the line for any other text and for numbers that are not between 1e-150 and
///         1e150.
AreaFile parse_areas(const std::string& name, std::string_view text);

/// Reads the areas of a regular file.
AreaFile read_areas(const std::string& path);

/// Requires one area for each site, and that none is below kLeastArea of their mean.
/// @throws BadFile naming the line.
void require_areas(const AreaFile& file, int n_sites);

}  // namespace pcvt
