#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mesher/mesh/mesh_kind.hpp"

namespace pcvt {

/// `cells`, `triangles` or `grains`, as the files spell it.
std::string kind_word(MeshKind kind);
std::optional<MeshKind> kind_of_word(std::string_view word);

}  // namespace pcvt
