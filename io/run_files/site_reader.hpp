#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/bad_file.hpp"
#include "mesher/lattice/lattice.hpp"

namespace pcvt {

/// Sites as a text file gives them; SiteId s is the s-th line that holds a site.
struct SiteFile {
    /// The file's name for messages.
    std::string name;
    /// 2 x n, length units, not wrapped.
    Points points;
    /// The line of each site, from 1.
    std::vector<int> lines;
};

/// Reads "x y" a line. Blank lines, what follows a #, CRLF, a byte order mark, tabs and a last line
/// without an end are accepted.
/// @throws BadFile for anything else, with the line, and for a text without a site.
SiteFile parse_sites(const std::string& name, std::string_view text);

/// The same from a file, or from standard input where `path` is "-".
SiteFile read_sites(const std::string& path);

/// `duplicate` told by lines: `file:7: the site is that of line 3 ...; remove one`.
BadFile duplicate_lines(const SiteFile& file, const DuplicateSites& duplicate);

}  // namespace pcvt
