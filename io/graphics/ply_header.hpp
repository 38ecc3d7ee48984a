#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/text.hpp"
#include "io/tiles/file_tile_builder.hpp"

namespace pcvt {

/// The integers that a declared type holds.
struct PlyRange {
    std::int64_t least = 0;
    std::int64_t most = 0;
};

/// One declared property: `is_real` holds for float and double, `is_single` for float alone.
struct PlyProperty {
    std::string_view name;
    bool is_real;
    bool is_single;
    bool is_list;
    /// Of integers, and of the lengths of lists.
    PlyRange values;
    PlyRange lengths;
    /// As declared: "uchar", "list uchar int".
    std::string type;
};

/// One declared element: `element NAME COUNT`, and the properties after it.
struct PlyElement {
    std::string_view name;
    int count;
    std::vector<PlyProperty> properties;

    /// Returns the property of this name; nullptr if there is none.
    const PlyProperty* find(std::string_view property) const;
};

/// Reads the header of an ASCII PLY up to `end_header`. The comments `pcvt kind`, `pcvt lattice`
/// and those of the notes of the tile (site_notes.hpp) fill `file`.
/// @returns the elements in the order of their declaration; names point into the scanner's text.
/// @throws BadFile with the line, also for a binary PLY.
std::vector<PlyElement> read_ply_header(LineScanner& scanner, FileTileBuilder& file);

}  // namespace pcvt
