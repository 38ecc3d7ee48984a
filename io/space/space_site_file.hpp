#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/bad_file.hpp"
#include "mesher/space/space_lattice.hpp"

namespace pcvt {

/// The sites of a text file; SiteId s belongs to the s-th line that holds a site, counted from 0.
///
/// Example usage:
///     const SpaceSiteFile file = read_space_sites("sites.txt");
///     const SpaceSites sites(lattice, file.points);
struct SpaceSiteFile {
    /// The file's name in messages.
    std::string name;
    /// 3 x n, length units, not wrapped.
    Points3 points;
    /// The line of each site, counted from 1.
    std::vector<int> lines;
};

/// Reads one site "x y z" per line. Accepts blank lines, comments after a #, CRLF, a byte order
/// mark, tabs and a last line without an end.
/// @throws BadFile with the line for any other text, and for a text without a site.
SpaceSiteFile parse_space_sites(const std::string& name, std::string_view text);

/// Reads the sites of a file, or of standard input if `path` is "-".
SpaceSiteFile read_space_sites(const std::string& path);

/// Returns `duplicate` with the lines of both sites in its message.
BadFile duplicate_lines(const SpaceSiteFile& file, const DuplicateSites& duplicate);

/// Encodes sites as a .txt file: a comment, then one site "x y z" per line. parse_space_sites()
/// returns exactly the same sites.
/// @throws InternalError if a coordinate is not finite.
std::string encode_space_sites(const Points3& points);

}  // namespace pcvt
