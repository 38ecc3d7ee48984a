#include "io/gltf/gltf_json.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "io/bytes/json.hpp"
#include "io/gltf/gltf_container.hpp"
#include "mesher/portable/decimal_text.hpp"

namespace pcvt {
namespace {

/// Numbers with decimal exponents outside of this range are written with their exponents.
constexpr double kLeastPlain = 1e-4;
constexpr double kMostPlain = 1e15;
/// About the number of bytes of an accessor, and of a node with its mesh and its material.
constexpr std::size_t kEntryBytes = 100;
constexpr std::size_t kNodeBytes = 400;

void append_comma(std::string& json) {
    if (json.back() != '{' && json.back() != '[') json += ',';
}

void append_key(std::string& json, std::string_view key) {
    append_comma(json);
    append_json_string(json, key);
    json += ':';
}

void append_entry(std::string& json, std::string_view key, std::string_view text) {
    append_key(json, key);
    append_json_string(json, text);
}

void append_entry(std::string& json, std::string_view key, std::size_t number) {
    append_key(json, key);
    json += std::to_string(number);
}

void append_entry(std::string& json, std::string_view key, int number) {
    append_entry(json, key, static_cast<std::size_t>(number));
}

/// Appends the shortest decimal number that reads back; whole numbers end in ".0".
void append_real(std::string& json, double value) {
    std::array<char, 32> digits;
    const double size = std::abs(value);
    const bool plain = value == 0 || (size >= kLeastPlain && size < kMostPlain);
    const auto format = plain ? std::chars_format::fixed : std::chars_format::scientific;
    char* const begin = digits.data();
    char* const end = write_decimal(begin, begin + digits.size(), value, format);
    json.append(begin, end);
    if (plain && std::find(begin, end, '.') == end) json += ".0";
}

void append_entry(std::string& json, std::string_view key, double value) {
    append_key(json, key);
    append_real(json, value);
}

/// Appends a named list; `append` writes an entry of it.
template <class Entries, class Append>
void append_list(std::string& json, std::string_view key, const Entries& entries,
                 const Append& append) {
    if (entries.empty()) return;
    append_key(json, key);
    json += '[';
    for (const auto& entry : entries) {
        append_comma(json);
        append(entry);
    }
    json += ']';
}

void append_entry(std::string& json, std::string_view key, const std::vector<double>& numbers) {
    append_list(json, key, numbers, [&](double number) { append_real(json, number); });
}

void append_entry(std::string& json, std::string_view key, const std::vector<int>& numbers) {
    append_list(json, key, numbers, [&](int number) { json += std::to_string(number); });
}

const char* type_word(int type) {
    switch (type) {
        case TINYGLTF_TYPE_VEC2:
            return "VEC2";
        case TINYGLTF_TYPE_VEC3:
            return "VEC3";
        default:
            return "SCALAR";
    }
}

void append_accessor(std::string& json, const tinygltf::Accessor& accessor) {
    json += '{';
    append_entry(json, "bufferView", accessor.bufferView);
    if (accessor.byteOffset > 0) append_entry(json, "byteOffset", accessor.byteOffset);
    append_entry(json, "componentType", accessor.componentType);
    append_entry(json, "count", accessor.count);
    append_entry(json, "max", accessor.maxValues);
    append_entry(json, "min", accessor.minValues);
    append_entry(json, "type", type_word(accessor.type));
    json += '}';
}

void append_view(std::string& json, const tinygltf::BufferView& view) {
    json += '{';
    append_entry(json, "buffer", view.buffer);
    append_entry(json, "byteLength", view.byteLength);
    if (view.byteOffset > 0) append_entry(json, "byteOffset", view.byteOffset);
    append_entry(json, "target", view.target);
    json += '}';
}

void append_material(std::string& json, const tinygltf::Material& material) {
    const tinygltf::PbrMetallicRoughness& surface = material.pbrMetallicRoughness;
    json += '{';
    append_key(json, "doubleSided");
    json += material.doubleSided ? "true" : "false";
    if (!material.extensions.empty()) {
        append_key(json, "extensions");
        json += '{';
        for (const auto& [name, value] : material.extensions) {
            append_key(json, name);
            json += "{}";
        }
        json += '}';
    }
    append_entry(json, "name", material.name);
    append_key(json, "pbrMetallicRoughness");
    json += '{';
    // White is the default.
    if (surface.baseColorFactor != std::vector<double>(4, 1)) {
        append_entry(json, "baseColorFactor", surface.baseColorFactor);
    }
    append_entry(json, "metallicFactor", surface.metallicFactor);
    append_entry(json, "roughnessFactor", surface.roughnessFactor);
    json += "}}";
}

void append_primitive(std::string& json, const tinygltf::Primitive& primitive) {
    json += '{';
    append_key(json, "attributes");
    json += '{';
    for (const auto& [name, accessor] : primitive.attributes) append_entry(json, name, accessor);
    json += '}';
    append_entry(json, "indices", primitive.indices);
    append_entry(json, "material", primitive.material);
    append_entry(json, "mode", primitive.mode);
    json += '}';
}

void append_mesh(std::string& json, const tinygltf::Mesh& mesh) {
    json += '{';
    append_entry(json, "name", mesh.name);
    append_list(json, "primitives", mesh.primitives,
                [&](const auto& primitive) { append_primitive(json, primitive); });
    json += '}';
}

/// @param periodic  empty unless this is the node of the tile.
void append_node(std::string& json, const tinygltf::Node& node, std::string_view periodic) {
    json += '{';
    append_entry(json, "children", node.children);
    if (!periodic.empty()) {
        append_key(json, "extras");
        json += '{';
        append_key(json, "periodic");
        json += periodic;
        json += '}';
    }
    if (node.mesh >= 0) append_entry(json, "mesh", node.mesh);
    append_entry(json, "name", node.name);
    append_entry(json, "translation", node.translation);
    json += '}';
}

void append_buffer(std::string& json, const std::vector<unsigned char>& buffer, bool embedded) {
    append_key(json, "buffers");
    json += "[{";
    append_entry(json, "byteLength", buffer.size());
    if (embedded) {
        append_key(json, "uri");
        json += '"';
        append_data_uri(json, buffer);
        json += '"';
    }
    json += "}]";
}

}  // namespace

std::string gltf_json(const tinygltf::Model& model, std::string_view periodic,
                      const std::vector<unsigned char>& buffer, bool embedded) {
    std::string json;
    json.reserve(kEntryBytes * model.accessors.size() + kNodeBytes * model.materials.size() +
                 periodic.size() + (embedded ? 2 * buffer.size() : 0));
    json += '{';
    append_list(json, "accessors", model.accessors,
                [&](const auto& accessor) { append_accessor(json, accessor); });
    append_key(json, "asset");
    json += '{';
    append_entry(json, "generator", model.asset.generator);
    append_entry(json, "version", model.asset.version);
    json += '}';
    append_list(json, "bufferViews", model.bufferViews,
                [&](const auto& view) { append_view(json, view); });
    append_buffer(json, buffer, embedded);
    append_list(json, "extensionsUsed", model.extensionsUsed,
                [&](const auto& name) { append_json_string(json, name); });
    append_list(json, "materials", model.materials,
                [&](const auto& material) { append_material(json, material); });
    append_list(json, "meshes", model.meshes, [&](const auto& mesh) { append_mesh(json, mesh); });
    append_list(json, "nodes", model.nodes, [&](const auto& node) {
        append_node(json, node, &node == model.nodes.data() ? periodic : "");
    });
    append_entry(json, "scene", model.defaultScene);
    append_list(json, "scenes", model.scenes, [&](const auto& scene) {
        json += '{';
        append_entry(json, "nodes", scene.nodes);
        json += '}';
    });
    return json += '}';
}

}  // namespace pcvt
