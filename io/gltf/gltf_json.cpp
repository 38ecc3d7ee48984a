#include "io/gltf/gltf_json.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "io/bytes/json_writer.hpp"
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

/// Appends the shortest decimal number that reads back; whole numbers end in ".0".
void append_real(JsonWriter& json, double value) {
    std::array<char, 32> digits;
    const double size = std::abs(value);
    const bool plain = value == 0 || (size >= kLeastPlain && size < kMostPlain);
    const auto format = plain ? std::chars_format::fixed : std::chars_format::scientific;
    char* const begin = digits.data();
    char* end = write_decimal(begin, begin + digits.size() - 2, value, format);
    if (plain && std::find(begin, end, '.') == end) {
        *end++ = '.';
        *end++ = '0';
    }
    json.raw({begin, static_cast<std::size_t>(end - begin)});
}

void append_real(JsonWriter& json, const char* key, double value) {
    json.key(key);
    append_real(json, value);
}

/// Appends a list as a member unless it is empty; `append_entry` appends an entry.
template <class Entries, class AppendEntry>
void append_list(JsonWriter& json, const char* key, const Entries& entries,
                 const AppendEntry& append_entry) {
    if (!entries.empty()) json.list(key, entries, append_entry);
}

void append_reals(JsonWriter& json, const char* key, const std::vector<double>& numbers) {
    append_list(json, key, numbers, [&](double number) { append_real(json, number); });
}

void append_values(JsonWriter& json, const char* key, const auto& values) {
    if (!values.empty()) json.member(key, values);
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

void append_accessor(JsonWriter& json, const tinygltf::Accessor& accessor) {
    json.begin_object();
    json.member("bufferView", accessor.bufferView);
    if (accessor.byteOffset > 0) json.member("byteOffset", accessor.byteOffset);
    json.member("componentType", accessor.componentType);
    json.member("count", accessor.count);
    append_reals(json, "max", accessor.maxValues);
    append_reals(json, "min", accessor.minValues);
    json.member("type", type_word(accessor.type));
    json.end();
}

void append_view(JsonWriter& json, const tinygltf::BufferView& view) {
    json.begin_object();
    json.member("buffer", view.buffer);
    json.member("byteLength", view.byteLength);
    if (view.byteOffset > 0) json.member("byteOffset", view.byteOffset);
    json.member("target", view.target);
    json.end();
}

void append_material(JsonWriter& json, const tinygltf::Material& material) {
    const tinygltf::PbrMetallicRoughness& surface = material.pbrMetallicRoughness;
    json.begin_object();
    json.member("doubleSided", material.doubleSided);
    if (!material.extensions.empty()) {
        json.object("extensions", [&] {
            for (const auto& [name, value] : material.extensions) json.object(name, [] {});
        });
    }
    json.member("name", material.name);
    json.object("pbrMetallicRoughness", [&] {
        // White is the default.
        if (surface.baseColorFactor != std::vector<double>(4, 1)) {
            append_reals(json, "baseColorFactor", surface.baseColorFactor);
        }
        append_real(json, "metallicFactor", surface.metallicFactor);
        append_real(json, "roughnessFactor", surface.roughnessFactor);
    });
    json.end();
}

void append_primitive(JsonWriter& json, const tinygltf::Primitive& primitive) {
    json.begin_object();
    json.object("attributes", [&] {
        for (const auto& [name, accessor] : primitive.attributes) json.member(name, accessor);
    });
    json.member("indices", primitive.indices);
    json.member("material", primitive.material);
    json.member("mode", primitive.mode);
    json.end();
}

void append_mesh(JsonWriter& json, const tinygltf::Mesh& mesh) {
    json.begin_object();
    json.member("name", mesh.name);
    append_list(json, "primitives", mesh.primitives,
                [&](const auto& primitive) { append_primitive(json, primitive); });
    json.end();
}

/// @param periodic  empty unless this is the node of the tile.
void append_node(JsonWriter& json, const tinygltf::Node& node, std::string_view periodic) {
    json.begin_object();
    append_values(json, "children", node.children);
    if (!periodic.empty()) {
        json.object("extras", [&] {
            json.key("periodic");
            json.raw(periodic);
        });
    }
    if (node.mesh >= 0) json.member("mesh", node.mesh);
    json.member("name", node.name);
    append_reals(json, "translation", node.translation);
    json.end();
}

/// @param text  to which `json` appends.
void append_buffer(JsonWriter& json, std::string& text, const std::vector<unsigned char>& buffer,
                   bool embedded) {
    json.key("buffers");
    json.begin_list();
    json.begin_object();
    json.member("byteLength", buffer.size());
    if (embedded) {
        json.key("uri");
        json.raw("\"");
        append_data_uri(text, buffer);
        text += '"';
    }
    json.end();
    json.end();
}

}  // namespace

std::string gltf_json(const tinygltf::Model& model, std::string_view periodic,
                      const std::vector<unsigned char>& buffer, bool embedded) {
    std::string text;
    text.reserve(kEntryBytes * model.accessors.size() + kNodeBytes * model.materials.size() +
                 periodic.size() + (embedded ? 2 * buffer.size() : 0));
    JsonWriter json(text, kCompactJson);
    json.begin_object();
    append_list(json, "accessors", model.accessors,
                [&](const auto& accessor) { append_accessor(json, accessor); });
    json.object("asset", [&] {
        json.member("generator", model.asset.generator);
        json.member("version", model.asset.version);
    });
    append_list(json, "bufferViews", model.bufferViews,
                [&](const auto& view) { append_view(json, view); });
    append_buffer(json, text, buffer, embedded);
    append_values(json, "extensionsUsed", model.extensionsUsed);
    append_list(json, "materials", model.materials,
                [&](const auto& material) { append_material(json, material); });
    append_list(json, "meshes", model.meshes, [&](const auto& mesh) { append_mesh(json, mesh); });
    append_list(json, "nodes", model.nodes, [&](const auto& node) {
        append_node(json, node, &node == model.nodes.data() ? periodic : "");
    });
    json.member("scene", model.defaultScene);
    append_list(json, "scenes", model.scenes, [&](const auto& scene) {
        json.begin_object();
        append_values(json, "nodes", scene.nodes);
        json.end();
    });
    json.end();
    return text;
}

}  // namespace pcvt
