#include "io/gltf/gltf_surface.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "io/gltf/gltf_writer.hpp"
#include "mesher/base/cancellable_sort.hpp"

namespace pcvt {
namespace {

/// Returns the colour of each vertex as linear light.
std::vector<Point3> lights(const TileColours& colours) {
    std::vector<Point3> light_of;
    for (const ColourClass& shown : colours.classes) {
        const Colour light = linear(shown.colour);
        light_of.push_back({static_cast<float>(light.r), static_cast<float>(light.g),
                            static_cast<float>(light.b)});
    }
    std::vector<Point3> result;
    result.reserve(colours.class_of.size());
    for (const int k : colours.class_of) result.push_back(light_of[k]);
    return result;
}

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

Surface cells(const plane::Tile& tile, const TileColours& colours, bool cell_nodes,
              const std::string& path) {
    Surface surface;
    surface.points = single_precision_points(tile, path);
    // A face of k corners has k - 2 triangles.
    surface.indices.reserve(
        3 * (tile.faces.corners.size() - 2 * static_cast<std::size_t>(tile.n_faces())));
    int face_before = -1;
    for (const int f : face_order(tile, colours.class_of, cell_nodes)) {
        // A face begins a group where its key differs from that of the face before.
        const SiteId site = tile.face_site[f];
        const SurfaceGroup group{colours.class_of[f], cell_nodes ? site : -1};
        const bool same = !surface.groups.empty() && surface.groups.back().site == group.site &&
                          (cell_nodes || surface.groups.back().colour == group.colour);
        if (!same) {
            surface.groups.push_back(group);
            surface.group_begin.push_back(surface.group_begin.back());
        }
        const std::size_t before = surface.indices.size();
        if (tile.kind == plane::MeshKind::kGrains) {
            surface.indices.insert(surface.indices.end(), tile.faces[f].begin(),
                                   tile.faces[f].end());
        } else {
            append_fan(tile, f, face_before, surface.points, surface.indices, path);
        }
        face_before = f;
        surface.group_begin.back() = static_cast<int>(surface.indices.size());
        if (cell_nodes) continue;
        if (surface.cells.empty() || surface.cells.back().site != site) {
            surface.cells.push_back({site, 0});
        }
        surface.cells.back().n_triangles += static_cast<int>(surface.indices.size() - before) / 3;
    }
    return surface;
}

Surface triangles(const plane::Tile& tile, const TileColours& colours, const std::string& path) {
    Surface surface;
    surface.points = single_precision_points(tile, path);
    surface.indices = tile.faces.corners;
    surface.vertex_colour = lights(colours);
    return surface;
}

}  // namespace

Surface make_surface(const plane::Tile& tile, const TileColours& colours, GltfNodes nodes,
                     const std::string& path) {
    if (!faces_have_sites(tile.kind)) return triangles(tile, colours, path);
    return cells(tile, colours, has_cell_nodes(tile, nodes), path);
}

}  // namespace pcvt
