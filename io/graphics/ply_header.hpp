#pragma once

#include <string_view>
#include <vector>

#include "io/bytes/text.hpp"
#include "io/tiles/raw_tile.hpp"

namespace pcvt {

struct PlyProperty {
    std::string_view name;
    bool is_real;
    bool is_single;
    bool is_list;
};

struct PlyElement {
    std::string_view name;
    int count;
    std::vector<PlyProperty> properties;

    /// nullptr if there is none of this name.
    const PlyProperty* find(std::string_view property) const;
};

/// Reads the header of an ASCII PLY up to `end_header`; our comments go to raw.kind and
/// raw.lattice.
/// @returns the elements as declared; names point into the scanner's text.
/// @throws BadFile with the line, also for a binary PLY.
std::vector<PlyElement> read_ply_header(LineScanner& scanner, RawTile& raw);

}  // namespace pcvt
