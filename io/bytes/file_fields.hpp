#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/encoded_file.hpp"

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

/// The fields of a file that follow from its tile; nothing for a file whose fields are a user's.
using FieldReader = std::optional<FileFields>(const std::string& path, std::string_view text);

/// Compares the fields of files with those of the files that the writer gives for their tile, where
/// the bytes of a path differ.
/// @throws BadFile  as compare_fields().
void compare_files(const std::vector<EncodedFile>& files, const std::vector<EncodedFile>& expected,
                   FieldReader* fields);

}  // namespace pcvt
