#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace pcvt {

/// A table as users name it: [PREFIX:]FILE[:COLUMN,COLUMN,...].
///
/// Example usage:
///     const TableName name = parse_table_name("rad:ebsd.csv:phi1,Phi,phi2", {"rad", "deg"});
///     const std::string text = read_whole_file(name.path, kSiteInput);
struct TableName {
    /// The file; "-" is standard input where an option reads that.
    std::string path;
    /// Names of the header, or numbers from 1; empty if the reader finds the columns.
    std::vector<std::string> columns = {};
    /// The word before the first colon, such as "rad"; empty without one.
    std::string prefix = {};
};

/// Splits the name of a table. A file that exists wins over every split, so that names of files
/// may hold colons: first under the whole text, then behind the prefix. Without such a file, the
/// last colon begins the columns.
/// @param prefixes  the words that the option knows, without their colons.
TableName parse_table_name(const std::string& text,
                           std::initializer_list<std::string_view> prefixes = {});

/// Writes a name as a user would type it: `name` with this prefix and these columns, for messages.
/// Quotes it where a shell would split it.
///
///     with_columns({.path = "ebsd.csv"}, "diameter", "ECD")  // "diameter:ebsd.csv:ECD"
///     with_columns({.path = "my.csv"}, "area", "Grain area")  // "'area:my.csv:Grain area'"
std::string with_columns(const TableName& name, const std::string& prefix,
                         const std::string& columns);

}  // namespace pcvt
