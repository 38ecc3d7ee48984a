#pragma once

#include <tiny_gltf.h>

#include <string>
#include <string_view>
#include <vector>

namespace pcvt {

/// Returns the JSON of a model that a ModelBuilder made. tinygltf's own serialisation aborts the
/// process where memory is exhausted: Debian builds it with the assertions of nlohmann/json, whose
/// destructor allocates.
///
/// @param periodic  the JSON of extras.periodic of the first node.
/// @param buffer    the one buffer.
/// @param embedded  whether the JSON holds the buffer as a data URI.
std::string gltf_json(const tinygltf::Model& model, std::string_view periodic,
                      const std::vector<unsigned char>& buffer, bool embedded);

}  // namespace pcvt
