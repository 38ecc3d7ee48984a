#include "io/gltf/gltf_model_builder.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "io/gltf/gltf_json.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"

namespace pcvt {
namespace {

/// tinygltf stores offsets as int.
constexpr std::size_t kMostBytes = std::numeric_limits<int>::max();

}  // namespace

void require_gltf_size(std::size_t n_bytes, const std::string& path) {
    if (n_bytes <= kMostBytes) return;
    throw LimitExceeded(path + ": more than 2 GiB, too large for glTF; write another format");
}

ModelBuilder::ModelBuilder(std::size_t n_bytes, const Eigen::Vector3d& translation) {
    model_.asset.generator = "pcvt";
    model_.asset.version = "2.0";
    model_.buffers.emplace_back().data.reserve(n_bytes);
    model_.scenes.emplace_back().nodes = {0};
    model_.defaultScene = 0;
    tinygltf::Node& tile = model_.nodes.emplace_back();
    tile.name = "tile";
    if (!translation.isZero(0)) tile.translation.assign(translation.begin(), translation.end());
}

int ModelBuilder::add_floats(std::span<const float> numbers, std::size_t width) {
    const int view = add_view(numbers.data(), numbers.size_bytes(), TINYGLTF_TARGET_ARRAY_BUFFER);
    const int type = width == 1   ? TINYGLTF_TYPE_SCALAR
                     : width == 2 ? TINYGLTF_TYPE_VEC2
                                  : TINYGLTF_TYPE_VEC3;
    return add_accessor(view, 0, TINYGLTF_COMPONENT_TYPE_FLOAT, numbers.size() / width, type);
}

int ModelBuilder::add_positions(const std::vector<Point3>& points) {
    const int id = add_vertex_data(points);
    tinygltf::Accessor& accessor = model_.accessors.back();
    accessor.minValues.assign(points[0].begin(), points[0].end());
    accessor.maxValues = accessor.minValues;
    for (const Point3& p : points) {
        checkpoint();
        for (std::size_t k = 0; k < p.size(); ++k) {
            accessor.minValues[k] = std::min(accessor.minValues[k], double(p[k]));
            accessor.maxValues[k] = std::max(accessor.maxValues[k], double(p[k]));
        }
    }
    return id;
}

int ModelBuilder::add_indices(const std::vector<int>& indices, const std::vector<int>& begin,
                              std::size_t n_vertices) {
    // The largest index of each width is reserved for primitive restart.
    const bool is_short = n_vertices <= std::numeric_limits<std::uint16_t>::max();
    const int view =
        is_short ? add_index_view<std::uint16_t>(indices) : add_index_view<std::uint32_t>(indices);
    const int type =
        is_short ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT : TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    const std::size_t width = is_short ? sizeof(std::uint16_t) : sizeof(std::uint32_t);
    for (std::size_t k = 0; k + 1 < begin.size(); ++k) {
        add_accessor(view, static_cast<std::size_t>(begin[k]) * width, type,
                     static_cast<std::size_t>(begin[k + 1] - begin[k]), TINYGLTF_TYPE_SCALAR);
    }
    return static_cast<int>(model_.accessors.size() - begin.size()) + 1;
}

int ModelBuilder::add_material(const std::string& name, Colour colour) {
    tinygltf::Material& material = model_.materials.emplace_back();
    material.name = name;
    material.doubleSided = true;
    material.pbrMetallicRoughness.metallicFactor = 0;
    material.pbrMetallicRoughness.roughnessFactor = 0.9;
    material.pbrMetallicRoughness.baseColorFactor.clear();
    const Colour light = linear(colour);
    for (const double component : {light.r, light.g, light.b}) {
        const double four_decimals = std::round(1e4 * component) / 1e4;
        material.pbrMetallicRoughness.baseColorFactor.push_back(four_decimals);
    }
    material.pbrMetallicRoughness.baseColorFactor.push_back(1);
    return static_cast<int>(model_.materials.size()) - 1;
}

int ModelBuilder::add_unlit_material(const std::string& name, Colour colour) {
    constexpr const char* kUnlit = "KHR_materials_unlit";
    const int material = add_material(name, colour);
    model_.materials.back().extensions[kUnlit] = tinygltf::Value(tinygltf::Value::Object{});
    model_.extensionsUsed.emplace_back(kUnlit);
    return material;
}

void ModelBuilder::add_node(const std::string& name, std::vector<tinygltf::Primitive> primitives) {
    tinygltf::Mesh& mesh = model_.meshes.emplace_back();
    mesh.name = name;
    mesh.primitives = std::move(primitives);
    model_.nodes[0].children.push_back(static_cast<int>(model_.nodes.size()));
    tinygltf::Node& node = model_.nodes.emplace_back();
    node.name = name;
    node.mesh = static_cast<int>(model_.meshes.size()) - 1;
}

std::vector<EncodedFile> ModelBuilder::encode(const std::string& path, std::string_view periodic,
                                              GltfContainer container) && {
    const std::vector<unsigned char> buffer = std::move(model_.buffers[0].data);
    require_gltf_size(buffer.size(), path);
    const bool is_text = container == GltfContainer::kText;
    std::string json = gltf_json(model_, periodic, buffer, is_text);
    if (!is_text) return only_file(path, glb_bytes(json, buffer));
    return only_file(path, std::move(json += '\n'));
}

int ModelBuilder::add_view(const void* data, std::size_t size, int target) {
    std::vector<unsigned char>& bytes = model_.buffers[0].data;
    tinygltf::BufferView& view = model_.bufferViews.emplace_back();
    view.buffer = 0;
    view.byteOffset = bytes.size();
    view.byteLength = size;
    view.target = target;
    const auto* begin = static_cast<const unsigned char*>(data);
    checkpoint();
    bytes.insert(bytes.end(), begin, begin + size);
    bytes.resize((bytes.size() + 3) / 4 * 4);
    return static_cast<int>(model_.bufferViews.size()) - 1;
}

int ModelBuilder::add_accessor(int view, std::size_t offset, int component_type, std::size_t count,
                               int type) {
    tinygltf::Accessor& accessor = model_.accessors.emplace_back();
    accessor.bufferView = view;
    accessor.byteOffset = offset;
    accessor.componentType = component_type;
    accessor.count = count;
    accessor.type = type;
    return static_cast<int>(model_.accessors.size()) - 1;
}

}  // namespace pcvt
