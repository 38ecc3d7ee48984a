#pragma once

#include <string>

namespace pcvt {

/// The extension of `path` in lower case: "a/Tile.OBJ" has ".obj".
std::string lower_case_extension(const std::string& path);

/// The path of a file beside `path` that formats can name as one word: "a b/my tile.obj" has
/// "a b/my_tile.mtl".
std::string one_word_beside(const std::string& path, const char* extension);

}  // namespace pcvt
