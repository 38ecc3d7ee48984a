#pragma once

#include <cstdint>
#include <string>

#include "plugin/job/job.hpp"
#include "plugin/pcvt.h"

namespace pcvt::abi {

/// The kind and the outline of a number of the interface.
/// @throws InvalidInput for an unknown number.
plane::MeshKind tile_kind(std::int32_t kind);
plane::Outline tile_outline(std::int32_t outline);

/// The kind and outline of a tile.
struct Layout {
    plane::MeshKind kind = plane::MeshKind::kVoronoi;
    plane::Outline outline = plane::Outline::kWhole;
};

/// A call of pcvt_write().
struct WriteRequest {
    /// Empty: none, like `report`.
    std::string path = {};
    Layout layout = {};
    FileOptions files = {};
    std::string report = {};
    bool replace = false;
};

/// @param path  nullptr: none.
/// @throws InvalidInput naming the field.
WriteRequest write_request(const char* path, const pcvt_write_options& options, bool in_space);

}  // namespace pcvt::abi
