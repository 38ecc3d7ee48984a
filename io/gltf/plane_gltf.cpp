#include "io/gltf/plane_gltf.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>
#include <utility>

#include "io/bytes/json_writer.hpp"
#include "io/bytes/output_error.hpp"
#include "io/forms/finite.hpp"
#include "io/forms/site_notes.hpp"
#include "io/forms/triangle_fan.hpp"
#include "io/gltf/gltf_place.hpp"
#include "io/gltf/gltf_writer.hpp"
#include "mesher/base/bucket_sort.hpp"
#include "mesher/base/cancellable_sort.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/tile/texture_coordinates.hpp"

namespace pcvt {
namespace {

/// float32, the type of attributes, represents all integers up to here.
constexpr SiteId kMaxFloatSite = 1 << 24;
constexpr Colour kWhite{1, 1, 1};

/// The number of consecutive triangles of a cell.
struct CellTriangles {
    SiteId site;
    int n_triangles;
};

/// Returns whether each cell becomes a node.
bool has_cell_nodes(const plane::Tile& tile, GltfNodes nodes) {
    if (nodes != GltfNodes::kBySize) return nodes == GltfNodes::kCells;
    return tile.kind == plane::MeshKind::kVoronoi && tile.n_faces() <= kMaxCellNodes;
}

/// Returns the faces with all pieces of a cell in a row, and the cells by their colour unless
/// each is a node.
std::vector<int> face_order(const plane::Tile& tile, const std::vector<int>& class_of,
                            bool cell_nodes) {
    std::vector<int> order(class_of.size());
    std::iota(order.begin(), order.end(), 0);
    const auto key = [&](int f) {
        return std::tuple(cell_nodes ? 0 : class_of[f], tile.face_site[f]);
    };
    cancellable_stable_sort(order.begin(), order.end(),
                            [&](int f, int g) { return key(f) < key(g); });
    return order;
}

/// Makes the colour of a face that of the triangles that follow, in a node of its own where each
/// cell is one.
void begin_colour(ColourClass shown, SiteId site, bool cell_nodes, SurfaceMesh& mesh) {
    if (cell_nodes) {
        shown.name = "cell_" + std::to_string(site);
        mesh.groups.push_back({shown.name, mesh.faces.n_faces()});
    }
    mesh.classes.push_back(std::move(shown));
}

/// Adds the triangles of cells or grains. @returns the cells in the order of their triangles.
std::vector<CellTriangles> add_cells(const plane::Tile& tile, const TileColours& colours,
                                     bool cell_nodes, const std::vector<Point32>& points,
                                     const std::string& path, SurfaceMesh& mesh) {
    std::vector<CellTriangles> cells;
    Faces& triangles = mesh.faces;
    // A face of k corners has k - 2 triangles.
    triangles.corners.reserve(
        3 * (tile.faces.corners.size() - 2 * static_cast<std::size_t>(tile.n_faces())));
    if (!cell_nodes) mesh.groups.push_back({"cells", 0});
    int before = -1;
    for (const int f : face_order(tile, colours.class_of, cell_nodes)) {
        const SiteId site = tile.face_site[f];
        const int colour = colours.class_of[f];
        const bool is_new_cell = before < 0 || site != tile.face_site[before];
        if (is_new_cell) cells.push_back({site, 0});
        if (cell_nodes ? is_new_cell : before < 0 || colour != colours.class_of[before]) {
            begin_colour(colours.classes[colour], site, cell_nodes, mesh);
        }
        if (tile.kind == plane::MeshKind::kGrains) {
            triangles.add(tile.faces[f]);
        } else {
            append_fan(tile, f, before, points, triangles.corners, path);
        }
        for (int end = triangles.begin.back() + 3; end <= std::ssize(triangles.corners); end += 3) {
            triangles.begin.push_back(end);
        }
        const auto n_triangles = static_cast<std::size_t>(triangles.n_faces());
        cells.back().n_triangles += static_cast<int>(n_triangles - mesh.face_class.size());
        mesh.face_class.resize(n_triangles, static_cast<int>(mesh.classes.size()) - 1);
        before = f;
    }
    return cells;
}

/// Adds Delaunay triangles, which show the colours of their vertices.
void add_triangles(const plane::Tile& tile, TileColours colours, GltfSurface& surface) {
    SurfaceMesh& mesh = surface.mesh;
    mesh.faces = tile.faces;
    mesh.groups.push_back({"triangles", 0});
    mesh.classes = std::move(colours.classes);
    mesh.classes.insert(mesh.classes.begin(), {kWhite, "triangles", ""});
    mesh.face_class.assign(static_cast<std::size_t>(tile.n_faces()), 0);
    mesh.vertex_class = std::move(colours.class_of);
    for (int& colour : mesh.vertex_class) ++colour;
    surface.vertex_site = tile.vertex_site;
}

/// Returns the texture coordinates in glTF's orientation.
std::vector<plane::TextureCoordinate> downward(std::vector<plane::TextureCoordinate> coordinates) {
    for (auto& [u, v] : coordinates) v = 1 - v;
    return coordinates;
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

/// A member of extras.periodic; `append` appends its value.
template <class Append>
GltfExtra extra(std::string_view key, const Append& append) {
    GltfExtra member{.key = std::string(key), .json = {}};
    JsonWriter json(member.json, kCompactJson);
    append(json);
    return member;
}

GltfExtra note_extra(const StatedNote& stated) {
    const auto& [note, numbers] = stated;
    if (note->of_each_site) {
        return {.key = std::string(note->member),
                .json = {},
                .numbers = std::vector<float>(numbers.begin(), numbers.end()),
                .width = note->n_parts};
    }
    return extra(note->member, [&, one = note->n_parts == 1, &values = numbers](JsonWriter& json) {
        one ? json.value(values.front()) : json.value(values);
    });
}

/// Appends the edges of the holes by their names.
void append_holes(const plane::Tile& tile, JsonWriter& json) {
    json.begin_object();
    for (std::size_t k = 0; k < tile.holes.size(); ++k) {
        json.key(tile.holes[k]);
        json.begin_list();
        for (const auto& [wall, v, w] : tile.wall_edges) {
            if (wall == plane::WallId::hole(static_cast<int>(k))) json.value(std::array{v, w});
        }
        json.end();
    }
    json.end();
}

std::vector<GltfExtra> extras_of(const plane::Tile& tile, const std::vector<CellTriangles>& cells) {
    std::vector<GltfExtra> extras;
    if (tile.kind == plane::MeshKind::kGrains) {
        extras.push_back(
            extra("kind", [&](JsonWriter& json) { json.value(file_word(tile.kind)); }));
    }
    extras.push_back(extra("lattice", [&](JsonWriter& json) {
        json.value(std::array{tile.lattice.a(), tile.lattice.b()});
    }));
    for (const StatedNote& stated : stated_notes(tile)) extras.push_back(note_extra(stated));
    if (!tile.holes.empty()) {
        extras.push_back(extra("holes", [&](JsonWriter& json) { append_holes(tile, json); }));
    }
    if (!cells.empty()) {
        extras.push_back(extra("cellTriangles", [&](JsonWriter& json) {
            json.begin_list();
            for (const CellTriangles& cell : cells) {
                json.value(std::array{cell.site, cell.n_triangles});
            }
            json.end();
        }));
    }
    extras.push_back(extra("vertexPairs", [&](JsonWriter& json) {
        json.begin_list();
        for (const plane::VertexPair& pair : tile.vertex_pairs) {
            json.value(std::array{pair.v, pair.w, pair.offset.i, pair.offset.j});
        }
        json.end();
    }));
    return extras;
}

/// @param tile  near 0.
GltfSurface gltf_surface(const plane::Tile& tile, const FileOptions& options,
                         const std::string& path) {
    const std::vector<SiteId>& sites =
        faces_have_sites(tile.kind) ? tile.face_site : tile.vertex_site;
    if (*std::max_element(sites.begin(), sites.end()) >= kMaxFloatSite) {
        throw LimitExceeded(path + ": too many sites for glTF; write another format");
    }
    TileColours colours =
        tile_colours(tile, options.colouring.value_or(Colouring::kSides), options.quantities());
    const std::vector<Point32> points = single_precision_points(tile, path);
    GltfSurface surface;
    std::vector<CellTriangles> cells;
    if (faces_have_sites(tile.kind)) {
        const bool cell_nodes = has_cell_nodes(tile, options.gltf_nodes);
        cells = add_cells(tile, colours, cell_nodes, points, path, surface.mesh);
        if (cell_nodes) cells.clear();
    } else {
        add_triangles(tile, std::move(colours), surface);
    }
    surface.mesh.points.reserve(points.size());
    for (const auto& [x, y] : points) surface.mesh.points.emplace_back(x, y, 0);
    surface.mesh.texture = downward(texture_coordinates(tile));
    surface.normals.assign(points.size(), {0, 0, 1});
    surface.lines = edge_ends(tile, points);
    surface.extras = extras_of(tile, cells);
    return surface;
}

std::vector<EncodedFile> encode(const plane::Tile& tile, const FileOptions& options,
                                const std::string& path, GltfContainer container) {
    require_finite(tile);
    const plane::Vec2 translation = gltf_translation(tile);
    const bool is_near = translation == plane::Vec2::Zero();
    GltfSurface surface =
        gltf_surface(is_near ? tile : moved_by(tile, -translation), options, path);
    surface.translation.head<2>() = translation;
    return encode_gltf_surface(surface, path, container);
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
