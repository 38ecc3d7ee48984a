#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/bad_file.hpp"
#include "io/run_files/table_name.hpp"
#include "mesher/plane/geometry/lattice.hpp"

namespace pcvt {

/// The sites of a table; SiteId s belongs to the s-th row, counted from 0.
///
/// Example usage:
///     const SiteFile file = read_sites<2>(parse_table_name("sites.txt"));
///     const Sites sites(lattice, file.points);
template <int Dimension>
struct SiteFileOf {
    /// The file's name in messages.
    std::string name;
    /// Dimension x n, length units, not wrapped.
    Eigen::Matrix<double, Dimension, Eigen::Dynamic> points;
    /// The line of each site, counted from 1.
    std::vector<int> lines;
    /// The unit of the coordinates that the header states, such as um; empty without one.
    std::string unit = {};
};
using SiteFile = SiteFileOf<2>;
using SpaceSiteFile = SiteFileOf<3>;

// For 2 and 3 dimensions.

/// Reads one site "x y", or "x y z", a row: a table as TableScanner takes it. The columns are those
/// that are named; else in a header those called x, y and z, whatever others there are; else all.
/// @throws BadFile with the line for any other text, and for a text without a site.
template <int Dimension>
SiteFileOf<Dimension> parse_sites(const TableName& name, std::string_view text);

/// Reads the sites of a file, or of standard input if the path is "-".
template <int Dimension>
SiteFileOf<Dimension> read_sites(const TableName& name);

/// Whether `text` reads back as exactly these sites; needs no memory for them.
/// @throws BadFile as parse_sites does.
bool reads_back(const std::string& name, std::string_view text, const Eigen::Matrix2Xd& sites);
bool reads_back(const std::string& name, std::string_view text, const Eigen::Matrix3Xd& sites);

/// Returns `duplicate` with lines in its message: "file:7: the site coincides with the site of line
/// 3
/// ...; remove one ...", or "file:7: 2 sites coincide with earlier ones ...: line 7 with line 3,
/// line 9 with line 3; ...".
BadFile duplicate_lines(const SiteFile& file, const DuplicateSites& duplicate);
BadFile duplicate_lines(const SpaceSiteFile& file, const DuplicateSites& duplicate);

}  // namespace pcvt
