#include "io/gltf/gltf_scene.hpp"

#include <cmath>
#include <string>

namespace pcvt {
namespace {

/// Returns the translation of a node itself.
plane::Vec2 translation_of(const Json& node, const GltfDocument& document) {
    if (!node.contains("translation")) return plane::Vec2::Zero();
    const auto numbers = GltfDocument::number_list(GltfDocument::member(node, "translation"), 3);
    if (!numbers.empty() && std::isfinite(numbers[0]) && std::isfinite(numbers[1])) {
        return {numbers[0], numbers[1]};
    }
    document.throw_bad_file("the translation of a node is not [x, y, z]; export the file again");
}

void require_upright(const Json& node, const GltfDocument& document) {
    for (const char* key : {"matrix", "rotation", "scale"}) {
        if (!node.contains(key)) continue;
        document.throw_bad_file("a node is moved by '" + std::string(key) +
                                "'; apply the transformation before exporting");
    }
}

/// A node to be visited, and the translation of the nodes above it.
struct WaitingNode {
    std::size_t index;
    plane::Vec2 above;
};

void push_nodes(const Json& parent, const std::string& key, const plane::Vec2& translation,
                const GltfDocument& document, std::vector<WaitingNode>& stack) {
    const Json& children = GltfDocument::member(parent, key);
    if (children.is_null()) return;
    if (!children.is_array()) document.throw_bad_file("'" + key + "' is not a list");
    for (std::size_t k = children.size(); k-- > 0;) {
        stack.push_back({document.count(children[k], key), translation});
    }
}

}  // namespace

std::vector<SceneNode> scene_nodes(const GltfDocument& document) {
    std::vector<SceneNode> nodes;
    std::vector<WaitingNode> stack;
    const std::size_t scene = document.count_in(document.root(), "scene", 0);
    push_nodes(document.entry("scenes", scene), "nodes", plane::Vec2::Zero(), document, stack);
    std::vector<bool> seen(GltfDocument::member(document.root(), "nodes").size());
    while (!stack.empty()) {
        const auto [index, above] = stack.back();
        stack.pop_back();
        const Json& node = document.entry("nodes", index);
        if (seen[index]) document.throw_bad_file("a node has two parents; export the file again");
        seen[index] = true;
        require_upright(node, document);
        nodes.push_back({&node, above + translation_of(node, document)});
        push_nodes(node, "children", nodes.back().translation, document, stack);
    }
    return nodes;
}

}  // namespace pcvt
