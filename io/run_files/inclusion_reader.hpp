#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mesher/plane/interfaces/inclusion.hpp"
#include "mesher/plane/interfaces/random_circles.hpp"

namespace pcvt {

/// The tag of the cells that lie in no inclusion.
inline constexpr const char* kMatrixTag = "matrix";

/// The inclusions in a text file.
///
/// Example usage:
///     const InclusionFile file = read_inclusions("fibres.txt");
///     const InclusionSet set(lattice, file.inclusions);
///     const std::string& material = file.tags[file.inclusions[0].tag - 1];
struct InclusionFile {
    /// The file's name, for messages and reports.
    std::string name;
    /// Inclusion::line counts from 1.
    std::vector<plane::Inclusion> inclusions;
    /// The words of the tags 1, 2, ... in the order in which they first occur.
    std::vector<std::string> tags;
};

/// Reads one inclusion a line; lengths are those of the period vectors:
///
///   circle TAG x y r
///   ellipse TAG x y a b degrees       the axis of a is turned by `degrees` from x to y
///   polygon TAG x1 y1 x2 y2 x3 y3 ...
///
/// Blanks, commas, semicolons or tabs separate the words; between semicolons or tabs numbers may
/// have decimal commas. A tag consists of letters, digits, _ and -, and is not `matrix`. Accepts
/// a header, quotes round words, blank lines, comments after a #, CRLF and a byte order mark.
/// @throws BadFile with the line for any other text, and for a text without an inclusion.
InclusionFile parse_inclusions(const std::string& name, std::string_view text);

/// Reads a regular file. @throws BadFile, LimitExceeded
InclusionFile read_inclusions(const std::string& path);

/// Requires that no tag has the name of a set, group or patch which files may contain beside those
/// of the tags.
/// @throws InvalidInput naming the first line with such a tag.
void require_tag_names(const InclusionFile& file);

/// Reads "FRACTION,N" or "FRACTION,N,GAP", such as 0.5,30.
/// @throws InvalidInput with the remedy.
plane::RandomCircles parse_fibres(std::string_view text);

/// Reads tags with commas between them, such as fibre,pore.
std::vector<std::string> parse_tags(std::string_view text);

}  // namespace pcvt
