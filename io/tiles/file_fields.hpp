#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace pcvt {

/// A word of a file and its line.
struct FileWord {
    std::string_view text;
    int line;
};

/// The words of a file by the part of the file that holds them: a section, an array, a set.
/// Comments and parts that do not depend on the tile are left out, and sets are in order, so that
/// two files of one tile have the same fields.
///
/// Example usage:
///     const FileFields found = *inp_fields("tile.inp", text);
///     const FileFields expected = *inp_fields("tile.inp", encode_inp(tile, {},
///     "tile.inp")[0].bytes); compare_fields(found, expected);
struct FileFields {
    /// The file's name in messages.
    std::string name;
    /// Views of the text, which must outlive this object.
    std::map<std::string, std::vector<FileWord>> parts = {};
};

/// Requires that both have the same parts with the same words. Numbers are compared by their
/// values.
/// @throws BadFile  naming the first part that differs, its line and both words.
void compare_fields(const FileFields& found, const FileFields& expected);

}  // namespace pcvt
