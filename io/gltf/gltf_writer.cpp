#include "io/gltf/gltf_writer.hpp"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <sstream>

#include "io/bytes/text.hpp"
#include "io/gltf/gltf_container.hpp"
#include "io/gltf/gltf_surface.hpp"
#include "io/tiles/finite.hpp"
#include "io/tiles/kind_word.hpp"
#include "io/tiles/palette.hpp"
#include "mesher/base/bucket_sort.hpp"
#include "mesher/tile/tile_valence.hpp"

namespace pcvt {
namespace {

/// tinygltf stores offsets as int.
constexpr std::size_t kMaxBytes = std::numeric_limits<int>::max();
/// float32, the type of attributes, represents all integers up to here.
constexpr SiteId kMaxSite = 1 << 24;
constexpr double kLift = 0.002;
constexpr Colour kLineColour{0.16, 0.17, 0.20};
constexpr Colour kWhite{1, 1, 1};

/// Builds a glTF model; every returned number is an index into one of its tables.
class ModelBuilder {
   public:
    /// @param n_bytes  the approximate size of the data.
    explicit ModelBuilder(std::size_t n_bytes) {
        model_.asset.generator = "pcvt";
        model_.asset.version = "2.0";
        model_.buffers.emplace_back().data.reserve(n_bytes);
        model_.scenes.emplace_back().nodes = {0};
        model_.defaultScene = 0;
        model_.nodes.emplace_back().name = "tile";
    }

    /// Adds an accessor with its own buffer view: one Element of floats per vertex.
    template <class Element>
    int add_vertex_data(const std::vector<Element>& elements, int type) {
        const int view = add_view(elements.data(), elements.size() * sizeof(Element),
                                  TINYGLTF_TARGET_ARRAY_BUFFER);
        return add_accessor(view, 0, TINYGLTF_COMPONENT_TYPE_FLOAT, elements.size(), type);
    }

    int add_positions(const std::vector<Point3>& points) {
        const int id = add_vertex_data(points, TINYGLTF_TYPE_VEC3);
        tinygltf::Accessor& accessor = model_.accessors.back();
        accessor.minValues.assign(points[0].begin(), points[0].end());
        accessor.maxValues = accessor.minValues;
        for (const Point3& p : points) {
            for (std::size_t k = 0; k < p.size(); ++k) {
                accessor.minValues[k] = std::min(accessor.minValues[k], double(p[k]));
                accessor.maxValues[k] = std::max(accessor.maxValues[k], double(p[k]));
            }
        }
        return id;
    }

    /// Adds accessors of ranges of `indices`, range k from begin[k] to begin[k + 1] - 1, in 16 bits
    /// if n_vertices permits. Returns the first accessor; the others follow it.
    int add_indices(const std::vector<int>& indices, const std::vector<int>& begin,
                    std::size_t n_vertices) {
        // The largest index of each width is reserved for primitive restart.
        const bool is_short = n_vertices <= std::numeric_limits<std::uint16_t>::max();
        const int view = is_short ? add_index_view<std::uint16_t>(indices)
                                  : add_index_view<std::uint32_t>(indices);
        const int type = is_short ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT
                                  : TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
        const std::size_t width = is_short ? sizeof(std::uint16_t) : sizeof(std::uint32_t);
        for (std::size_t k = 0; k + 1 < begin.size(); ++k) {
            add_accessor(view, static_cast<std::size_t>(begin[k]) * width, type,
                         static_cast<std::size_t>(begin[k + 1] - begin[k]), TINYGLTF_TYPE_SCALAR);
        }
        return static_cast<int>(model_.accessors.size() - begin.size()) + 1;
    }

    tinygltf::Material& add_material(const std::string& name, Colour colour) {
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
        return material;
    }

    /// Adds a child of the node `tile` with the material added last.
    void add_node(const std::string& name, tinygltf::Primitive primitive) {
        primitive.material = static_cast<int>(model_.materials.size()) - 1;
        tinygltf::Mesh& mesh = model_.meshes.emplace_back();
        mesh.name = name;
        mesh.primitives.push_back(std::move(primitive));
        model_.nodes[0].children.push_back(static_cast<int>(model_.nodes.size()));
        tinygltf::Node& node = model_.nodes.emplace_back();
        node.name = name;
        node.mesh = static_cast<int>(model_.meshes.size()) - 1;
    }

    tinygltf::Model& model() { return model_; }

   private:
    int add_view(const void* data, std::size_t size, int target) {
        std::vector<unsigned char>& bytes = model_.buffers[0].data;
        tinygltf::BufferView& view = model_.bufferViews.emplace_back();
        view.buffer = 0;
        view.byteOffset = bytes.size();
        view.byteLength = size;
        view.target = target;
        const auto* begin = static_cast<const unsigned char*>(data);
        bytes.insert(bytes.end(), begin, begin + size);
        bytes.resize((bytes.size() + 3) / 4 * 4);
        return static_cast<int>(model_.bufferViews.size()) - 1;
    }

    template <class Index>
    int add_index_view(const std::vector<int>& indices) {
        std::vector<Index> narrow;
        narrow.reserve(indices.size());
        for (const int index : indices) narrow.push_back(static_cast<Index>(index));
        return add_view(narrow.data(), narrow.size() * sizeof(Index),
                        TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    }

    int add_accessor(int view, std::size_t offset, int component_type, std::size_t count,
                     int type) {
        tinygltf::Accessor& accessor = model_.accessors.emplace_back();
        accessor.bufferView = view;
        accessor.byteOffset = offset;
        accessor.componentType = component_type;
        accessor.count = count;
        accessor.type = type;
        return static_cast<int>(model_.accessors.size()) - 1;
    }

    tinygltf::Model model_;
};

template <class Number>
void append_list(std::string& text, std::initializer_list<Number> numbers) {
    char before = '[';
    for (const Number number : numbers) {
        text += before;
        append_number(text, number);
        before = ',';
    }
    text += ']';
}

/// Returns extras.periodic as JSON. A tinygltf::Value would take 150 bytes per number.
std::string periodic_json(const Tile& tile, const Surface& surface) {
    const Vec2& a = tile.lattice.a();
    const Vec2& b = tile.lattice.b();
    std::string text = "{";
    if (tile.kind == MeshKind::kGrains) text += "\"kind\":\"" + kind_word(tile.kind) + "\",";
    // Lattice, copies, pairs.
    text += "\"lattice\":[";
    append_list(text, {a.x(), a.y()});
    text += ',';
    append_list(text, {b.x(), b.y()});
    text += "],";
    if (!surface.copies.empty()) {
        text += "\"vertexCopies\":[";
        for (const int v : surface.copies) {
            append_number(text, v);
            text += ',';
        }
        text.back() = ']';
        text += ',';
    }
    text += "\"vertexPairs\":[";
    for (const VertexPair& pair : tile.vertex_pairs) {
        append_list(text, {pair.v, pair.w, pair.offset.i, pair.offset.j});
        text += ',';
    }
    if (tile.vertex_pairs.empty()) return text + "]}";
    text.back() = ']';
    return text + '}';
}

std::vector<Point3> lifted(const std::vector<Point32>& points, float z) {
    std::vector<Point3> result;
    result.reserve(points.size());
    for (const Point32& p : points) result.push_back({p[0], p[1], z});
    return result;
}

void add_surface(const Tile& tile, const Surface& surface, ModelBuilder& builder) {
    // Positions and normals are shared by all primitives.
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.attributes["POSITION"] = builder.add_positions(lifted(surface.points, 0));
    primitive.attributes["NORMAL"] = builder.add_vertex_data(
        std::vector<Point3>(surface.points.size(), {0, 0, 1}), TINYGLTF_TYPE_VEC3);
    // Without vertex sites, each cell has a node of its own.
    if (surface.vertex_site.empty()) {
        const std::vector<int> sides = cell_sides(tile);
        primitive.indices =
            builder.add_indices(surface.indices, surface.face_begin, surface.points.size());
        for (int f = 0; f < tile.n_faces(); ++f, ++primitive.indices) {
            const std::string name = "cell_" + std::to_string(tile.face_site[f]);
            builder.add_material(name, side_colour(sides[f]));
            builder.add_node(name, primitive);
        }
        return;
    }
    // Else one node holds everything, and vertices have colours and sites.
    const bool cells = faces_have_sites(tile.kind);
    primitive.attributes["COLOR_0"] =
        builder.add_vertex_data(surface.vertex_colour, TINYGLTF_TYPE_VEC3);
    primitive.attributes[cells ? "_CELL_ID" : "_SITE_ID"] =
        builder.add_vertex_data(surface.vertex_site, TINYGLTF_TYPE_SCALAR);
    primitive.indices =
        builder.add_indices(surface.indices, {0, surface.face_begin.back()}, surface.points.size());
    builder.add_material(cells ? "cells" : "triangles", kWhite);
    builder.add_node(cells ? "cells" : "triangles", primitive);
}

/// Returns the ends of each edge in rising order, without edges that float32 collapses.
std::vector<int> edge_ends(const Tile& tile, const std::vector<Point32>& points) {
    std::vector<std::array<int, 2>> edges;
    for (int f = 0; f < tile.n_faces(); ++f) {
        int previous = tile.faces[f].back();
        for (const int v : tile.faces[f]) {
            if (points[v] != points[previous]) {
                edges.push_back({std::min(v, previous), std::max(v, previous)});
            }
            previous = v;
        }
    }
    bucket_sort(edges, static_cast<int>(points.size()), [](const auto& edge) { return edge[0]; });
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    std::vector<int> ends;
    for (const auto& edge : edges) ends.insert(ends.end(), edge.begin(), edge.end());
    return ends;
}

void add_outlines(const Tile& tile, const Surface& surface, ModelBuilder& builder) {
    const std::vector<Point32> points(surface.points.begin(),
                                      surface.points.end() - std::ssize(surface.copies));
    // Lift the lines above the surface.
    float size = 0;
    for (const std::size_t k : {0, 1}) {
        const auto less = [k](const Point32& p, const Point32& q) { return p[k] < q[k]; };
        const auto [least, most] = std::minmax_element(points.begin(), points.end(), less);
        size = std::max(size, (*most)[k] - (*least)[k]);
    }
    const std::vector<int> ends = edge_ends(tile, points);
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_LINE;
    primitive.attributes["POSITION"] =
        builder.add_positions(lifted(points, static_cast<float>(kLift) * size));
    primitive.indices =
        builder.add_indices(ends, {0, static_cast<int>(ends.size())}, points.size());
    builder.add_material("outlines", kLineColour).extensions["KHR_materials_unlit"] =
        tinygltf::Value(tinygltf::Value::Object{});
    builder.model().extensionsUsed.emplace_back("KHR_materials_unlit");
    builder.add_node("outlines", primitive);
}

enum class Container { kText, kBinary };

/// The placeholders in the JSON of a model for its extras.periodic and for its one buffer.
constexpr std::string_view kPeriodicMark = "\"periodic\":0";
constexpr std::string_view kBufferMark = "\"buffers\":[{\"byteLength\":0}]";
/// The number of bytes before the JSON in a .glb file.
constexpr std::size_t kGlbHeader = 20;

/// A model without its buffer and with the placeholder for its extras.
struct ModelParts {
    tinygltf::Model model;
    std::vector<unsigned char> buffer;
    std::string periodic;
};

ModelParts make_model(const Tile& tile, const std::string& path) {
    require_finite(tile);
    const std::vector<SiteId>& sites =
        faces_have_sites(tile.kind) ? tile.face_site : tile.vertex_site;
    if (*std::max_element(sites.begin(), sites.end()) >= kMaxSite) {
        throw LimitExceeded(path + ": too many sites for glTF; write another format");
    }
    const Surface surface = make_surface(tile, kMaxCellNodes, path);
    // Reserve up to four attributes per vertex, and the outlines.
    ModelBuilder builder(surface.points.size() * (3 * sizeof(Point3) + sizeof(float)) +
                         tile.points.size() * sizeof(Point3) +
                         (surface.indices.size() + 2 * tile.faces.corners.size()) * sizeof(int));
    add_surface(tile, surface, builder);
    add_outlines(tile, surface, builder);
    builder.model().nodes[0].extras =
        tinygltf::Value(tinygltf::Value::Object{{"periodic", tinygltf::Value(0)}});
    std::vector<unsigned char> buffer = std::move(builder.model().buffers[0].data);
    builder.model().buffers[0].data.clear();
    if (buffer.size() > kMaxBytes) {
        throw LimitExceeded(path + ": more than 2 GiB, too large for glTF; write another format");
    }
    return {std::move(builder.model()), std::move(buffer), periodic_json(tile, surface)};
}

/// Returns the text before and after a placeholder.
std::pair<std::string_view, std::string_view> cut(std::string_view json, std::string_view mark) {
    const std::size_t at = json.find(mark);
    if (at == std::string::npos) throw InternalError("a mark is missing in the JSON of a model");
    return {json.substr(0, at), json.substr(at + mark.size())};
}

/// Returns the JSON of a model as tinygltf writes it, with its placeholders.
std::string marked_json(const tinygltf::Model& model, const std::string& path) {
    std::ostringstream stream;
    tinygltf::TinyGLTF writer;
    // In a .glb file the buffer needs no URI, so that only a header surrounds the JSON.
    if (!writer.WriteGltfSceneToStream(&model, stream, false, true)) {
        throw InternalError(path + ": tinygltf refused the model");
    }
    std::string json = std::move(stream).str().substr(kGlbHeader);
    json.erase(json.find_last_not_of(' ') + 1);
    return json;
}

std::vector<EncodedFile> encode(const ModelParts& parts, const std::string& path,
                                Container container) {
    const bool is_text = container == Container::kText;
    const std::string marked = marked_json(parts.model, path);
    const auto [head, rest] = cut(marked, kBufferMark);
    const auto [middle, tail] = cut(rest, kPeriodicMark);
    std::string json;
    json.reserve(marked.size() + parts.periodic.size() + (is_text ? 2 * parts.buffer.size() : 0));
    json.append(head).append("\"buffers\":[{\"byteLength\":");
    json += std::to_string(parts.buffer.size());
    if (is_text) {
        json += ",\"uri\":\"";
        append_data_uri(json, parts.buffer);
        json += '"';
    }
    json.append("}]").append(middle).append("\"periodic\":").append(parts.periodic).append(tail);
    if (!is_text) return only_file(path, glb_bytes(json, parts.buffer));
    return only_file(path, std::move(json += '\n'));
}

}  // namespace

std::vector<EncodedFile> encode_gltf(const Tile& tile, const std::string& path) {
    return encode(make_model(tile, path), path, Container::kText);
}

std::vector<EncodedFile> encode_glb(const Tile& tile, const std::string& path) {
    return encode(make_model(tile, path), path, Container::kBinary);
}

}  // namespace pcvt
