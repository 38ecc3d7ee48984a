#pragma once

#include <vector>

#include "io/gltf/gltf_document.hpp"
#include "mesher/plane/geometry/lattice.hpp"

namespace pcvt {

/// A node of a scene, and its translation along x and y, those of the nodes above it included.
struct SceneNode {
    /// An entry of the document.
    const Json* node;
    plane::Vec2 translation;
};

/// Returns the nodes of the scene that a document shows, each before the nodes below it.
///
/// Example usage:
///   for (const SceneNode& placed : scene_nodes(document)) add_mesh(*placed.node);
///
/// @throws BadFile if a node is turned or scaled, or has two parents.
std::vector<SceneNode> scene_nodes(const GltfDocument& document);

}  // namespace pcvt
