#pragma once

#include "io/gltf/gltf_document.hpp"

namespace pcvt {

/// Whether pcvt wrote the file, with the positions of its sites, and no other program since.
bool is_own_gltf(const GltfDocument& document);

/// Proves that the tables of a file of pcvt refer to each other as encode_gltf() writes them, so
/// that every program that follows the indices finds the same tile:
///   - the views fill the one buffer in order, each aligned to four bytes, and the accessors of a
///     view fill it; a view's target is that of its accessors; each accessor is used;
///   - accessors of positions state their least and largest coordinates, others state none;
///   - the one scene shows node 0, whose children are all other nodes; node k has mesh k - 1, with
///     the same name; the primitives take the materials in order; a node `cell_<site>` has one
///     primitive, and a material of this name; the last node draws lines, all others triangles.
///
/// Example usage:
///   if (is_own_gltf(document)) require_own_layout(document);
/// @throws BadFile naming the entry.
void require_own_layout(const GltfDocument& document);

}  // namespace pcvt
