#pragma once

#include <string>

namespace pcvt {

/// The extension of `path` in lower case: "a/Tile.OBJ" has ".obj".
std::string lower_case_extension(const std::string& path);

}  // namespace pcvt
