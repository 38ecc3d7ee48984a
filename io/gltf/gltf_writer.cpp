#include "io/gltf/gltf_writer.hpp"

#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "io/bytes/json.hpp"
#include "io/bytes/text.hpp"
#include "io/colours/palette.hpp"
#include "io/gltf/gltf_model_builder.hpp"
#include "io/gltf/gltf_place.hpp"
#include "io/gltf/gltf_surface.hpp"
#include "io/tiles/finite.hpp"
#include "io/tiles/site_notes.hpp"
#include "mesher/base/bucket_sort.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/tile/texture_coordinates.hpp"

namespace pcvt {
namespace {

/// float32, the type of attributes, represents all integers up to here.
constexpr SiteId kMaxFloatSite = 1 << 24;
constexpr double kLift = 0.002;
constexpr Colour kLineColour{0.16, 0.17, 0.20};
constexpr Colour kWhite{1, 1, 1};

template <class Numbers>
void append_list(std::string& text, const Numbers& numbers) {
    char before = '[';
    for (const auto number : numbers) {
        text += before;
        append_number(text, number);
        before = ',';
    }
    text += ']';
}

/// Returns extras.periodic as JSON. A tinygltf::Value would take 150 bytes per number.
/// @param notes  the members that state the sites, each with a comma behind it.
std::string periodic_json(const plane::Tile& tile, const Surface& surface,
                          const std::string& notes) {
    const plane::Vec2& a = tile.lattice.a();
    const plane::Vec2& b = tile.lattice.b();
    std::string text = "{";
    if (tile.kind == plane::MeshKind::kGrains) text += "\"kind\":\"" + file_word(tile.kind) + "\",";
    // Lattice, cells, pairs.
    text += "\"lattice\":[";
    append_list(text, a);
    text += ',';
    append_list(text, b);
    text += "],";
    text += notes;
    if (!surface.cells.empty()) {
        text += "\"cellTriangles\":[";
        for (const CellTriangles& cell : surface.cells) {
            append_list(text, std::array{cell.site, cell.n_triangles});
            text += ',';
        }
        text.back() = ']';
        text += ',';
    }
    text += "\"vertexPairs\":[";
    for (const plane::VertexPair& pair : tile.vertex_pairs) {
        append_list(text, std::array{pair.v, pair.w, pair.offset.i, pair.offset.j});
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

/// Returns the texture coordinates in glTF's orientation.
std::vector<plane::TextureCoordinate> downward(std::vector<plane::TextureCoordinate> coordinates) {
    for (auto& [u, v] : coordinates) v = 1 - v;
    return coordinates;
}

void add_triangles(const plane::Tile& tile, const Surface& surface, tinygltf::Primitive primitive,
                   ModelBuilder& builder) {
    const std::vector<float> sites(tile.vertex_site.begin(), tile.vertex_site.end());
    primitive.attributes["COLOR_0"] =
        builder.add_vertex_data(surface.vertex_colour, TINYGLTF_TYPE_VEC3);
    primitive.attributes["_SITE_ID"] = builder.add_vertex_data(sites, TINYGLTF_TYPE_SCALAR);
    primitive.indices = builder.add_indices(
        surface.indices, {0, static_cast<int>(surface.indices.size())}, surface.points.size());
    builder.add_material("triangles", kWhite);
    primitive.material = builder.last_material();
    builder.add_node("triangles", {std::move(primitive)});
}

void add_cells(const Surface& surface, const TileColours& colours, tinygltf::Primitive primitive,
               ModelBuilder& builder) {
    primitive.indices =
        builder.add_indices(surface.indices, surface.group_begin, surface.points.size());
    std::vector<tinygltf::Primitive> primitives;
    for (const SurfaceGroup& group : surface.groups) {
        const ColourClass& shown = colours.classes[group.colour];
        const std::string name = group.site < 0 ? shown.name : "cell_" + std::to_string(group.site);
        builder.add_material(name, shown.colour);
        primitive.material = builder.last_material();
        primitives.push_back(primitive);
        ++primitive.indices;
        if (surface.is_one_node()) continue;
        builder.add_node(name, std::move(primitives));
        primitives.clear();
    }
    if (surface.is_one_node()) builder.add_node("cells", std::move(primitives));
}

void add_surface(const plane::Tile& tile, const Surface& surface, const TileColours& colours,
                 ModelBuilder& builder) {
    // All primitives share the attributes of vertices.
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.attributes["POSITION"] = builder.add_positions(lifted(surface.points, 0));
    primitive.attributes["NORMAL"] = builder.add_vertex_data(
        std::vector<Point3>(surface.points.size(), {0, 0, 1}), TINYGLTF_TYPE_VEC3);
    primitive.attributes["TEXCOORD_0"] =
        builder.add_vertex_data(downward(texture_coordinates(tile)), TINYGLTF_TYPE_VEC2);
    if (faces_have_sites(tile.kind)) {
        add_cells(surface, colours, std::move(primitive), builder);
    } else {
        add_triangles(tile, surface, std::move(primitive), builder);
    }
}

/// Returns the ends of each edge in rising order, without edges that float32 collapses.
std::vector<int> edge_ends(const plane::Tile& tile, const std::vector<Point32>& points) {
    std::vector<std::array<int, 2>> edges;
    edges.reserve(tile.faces.corners.size());
    for (int f = 0; f < tile.n_faces(); ++f) {
        checkpoint_each(f);
        int previous = tile.faces[f].back();
        for (const int v : tile.faces[f]) {
            if (points[v] != points[previous]) {
                edges.push_back({std::min(v, previous), std::max(v, previous)});
            }
            previous = v;
        }
    }
    bucket_sort(edges, static_cast<int>(points.size()), [](const auto& edge) { return edge[0]; });
    checkpoint();
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    checkpoint();
    std::vector<int> ends;
    ends.reserve(2 * edges.size());
    for (const auto& edge : edges) ends.insert(ends.end(), edge.begin(), edge.end());
    return ends;
}

void add_outlines(const plane::Tile& tile, const Surface& surface, ModelBuilder& builder) {
    const std::vector<Point32>& points = surface.points;
    // Lift the lines above the surface.
    float size = 0;
    for (const std::size_t k : {0, 1}) {
        const auto less = [k](const Point32& p, const Point32& q) { return p[k] < q[k]; };
        const auto [least, most] = std::minmax_element(points.begin(), points.end(), less);
        size = std::max(size, (*most)[k] - (*least)[k]);
    }
    checkpoint();
    const std::vector<int> ends = edge_ends(tile, points);
    checkpoint();
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_LINE;
    primitive.attributes["POSITION"] =
        builder.add_positions(lifted(points, static_cast<float>(kLift) * size));
    primitive.indices =
        builder.add_indices(ends, {0, static_cast<int>(ends.size())}, points.size());
    builder.add_material("outlines", kLineColour).extensions["KHR_materials_unlit"] =
        tinygltf::Value(tinygltf::Value::Object{});
    builder.model().extensionsUsed.emplace_back("KHR_materials_unlit");
    primitive.material = builder.last_material();
    builder.add_node("outlines", {std::move(primitive)});
}

/// Adds the numbers of a note of each site. @returns their accessor.
int add_site_note(const StatedNote& stated, ModelBuilder& builder) {
    const std::vector<double>& numbers = stated.numbers;
    if (stated.note->n_parts == 1) {
        return builder.add_vertex_data(std::vector<float>(numbers.begin(), numbers.end()),
                                       TINYGLTF_TYPE_SCALAR);
    }
    std::vector<Point32> pairs;
    for (std::size_t k = 0; k < numbers.size(); k += 2) {
        pairs.push_back({static_cast<float>(numbers[k]), static_cast<float>(numbers[k + 1])});
    }
    return builder.add_vertex_data(pairs, TINYGLTF_TYPE_VEC2);
}

/// Adds the notes of the sites. @returns the members of extras.periodic.
std::string add_site_notes(const plane::Tile& tile, ModelBuilder& builder) {
    std::string text;
    for (const StatedNote& stated : stated_notes(tile)) {
        text += '"' + std::string(stated.note->member) + "\":";
        if (stated.note->of_each_site) {
            append_number(text, add_site_note(stated, builder));
        } else if (stated.note->n_parts == 1) {
            append_number(text, stated.numbers.front());
        } else {
            append_list(text, stated.numbers);
        }
        text += ',';
    }
    return text;
}

/// @returns the member of extras.periodic that lists the edges of the holes by their names.
std::string hole_edges(const plane::Tile& tile) {
    if (tile.holes.empty()) return {};
    std::string text = "\"holes\":{";
    for (std::size_t k = 0; k < tile.holes.size(); ++k) {
        append_json_string(text, tile.holes[k]);
        text += ":[";
        for (const auto& [wall, v, w] : tile.wall_edges) {
            if (wall != plane::WallId::hole(static_cast<int>(k))) continue;
            append_list(text, std::array{v, w});
            text += ',';
        }
        text.back() = ']';
        text += ',';
    }
    text.back() = '}';
    return text + ',';
}

/// A model, and its extras.
struct ModelParts {
    ModelBuilder builder;
    std::string periodic;
};

/// @param tile  near 0.
ModelParts make_model(const plane::Tile& tile, const FileOptions& options,
                      const std::string& path) {
    const std::vector<SiteId>& sites =
        faces_have_sites(tile.kind) ? tile.face_site : tile.vertex_site;
    if (*std::max_element(sites.begin(), sites.end()) >= kMaxFloatSite) {
        throw LimitExceeded(path + ": too many sites for glTF; write another format");
    }
    const TileColours colours =
        tile_colours(tile, options.colouring.value_or(Colouring::kSides), options.quantities());
    const Surface surface = make_surface(tile, colours, options.gltf_nodes, path);
    // Reserve up to five attributes per vertex, the outlines, and the positions of the sites.
    ModelBuilder builder(
        surface.points.size() *
            (3 * sizeof(Point3) + sizeof(plane::TextureCoordinate) + sizeof(float)) +
        tile.points.size() * sizeof(Point3) + sites.size() * sizeof(Point32) +
        tile.site_weights.size() * sizeof(float) +
        (surface.indices.size() + 2 * tile.faces.corners.size()) * sizeof(int));
    add_surface(tile, surface, colours, builder);
    add_outlines(tile, surface, builder);
    const std::string notes = add_site_notes(tile, builder) + hole_edges(tile);
    return {std::move(builder), periodic_json(tile, surface, notes)};
}

std::vector<EncodedFile> encode(const plane::Tile& tile, const FileOptions& options,
                                const std::string& path, GltfContainer container) {
    require_finite(tile);
    const plane::Vec2 translation = gltf_translation(tile);
    const bool is_near = translation == plane::Vec2::Zero();
    ModelParts parts = make_model(is_near ? tile : moved_by(tile, -translation), options, path);
    if (!is_near) {
        parts.builder.model().nodes[0].translation = {translation.x(), translation.y(), 0};
    }
    return std::move(parts.builder).encode(path, parts.periodic, container);
}

}  // namespace

std::vector<EncodedFile> encode_gltf(const plane::Tile& tile, const FileOptions& options,
                                     const std::string& path) {
    return encode(tile, options, path, GltfContainer::kText);
}

std::vector<EncodedFile> encode_glb(const plane::Tile& tile, const FileOptions& options,
                                    const std::string& path) {
    return encode(tile, options, path, GltfContainer::kBinary);
}

}  // namespace pcvt
