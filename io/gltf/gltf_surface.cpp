#include "io/gltf/gltf_surface.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "io/gltf/gltf_writer.hpp"
#include "io/tiles/palette.hpp"
#include "mesher/tile/tile_valence.hpp"

namespace pcvt {
namespace {

/// Returns the colour of each number of sides as linear light.
std::vector<Point3> side_lights(const std::vector<int>& sides) {
    std::map<int, Point3> light_of;
    std::vector<Point3> lights;
    lights.reserve(sides.size());
    for (const int n : sides) {
        const auto [found, is_new] = light_of.try_emplace(n);
        if (is_new) {
            const Colour light = linear(side_colour(n));
            found->second = {static_cast<float>(light.r), static_cast<float>(light.g),
                             static_cast<float>(light.b)};
        }
        lights.push_back(found->second);
    }
    return lights;
}

/// Returns whether each cell becomes a node.
bool has_cell_nodes(const Tile& tile, GltfNodes nodes) {
    if (nodes != GltfNodes::kBySize) return nodes == GltfNodes::kCells;
    return tile.kind == MeshKind::kVoronoi && tile.n_faces() <= kMaxCellNodes;
}

/// Returns the faces with all pieces of a cell in a row, and the cells by their number of sides
/// unless each is a node.
std::vector<int> face_order(const Tile& tile, const std::vector<int>& sides, bool cell_nodes) {
    std::vector<int> order(sides.size());
    std::iota(order.begin(), order.end(), 0);
    const auto key = [&](int f) {
        return std::tuple(cell_nodes ? 0 : sides[f], tile.face_site[f]);
    };
    std::stable_sort(order.begin(), order.end(), [&](int f, int g) { return key(f) < key(g); });
    return order;
}

Surface cells(const Tile& tile, bool cell_nodes, const std::string& path) {
    Surface surface;
    surface.points = single_precision_points(tile, path);
    const std::vector<int> sides = cell_sides(tile);
    for (const int f : face_order(tile, sides, cell_nodes)) {
        // A face begins a group where its key differs from that of the face before.
        const SiteId site = tile.face_site[f];
        const SurfaceGroup group{sides[f], cell_nodes ? site : -1};
        const bool same = !surface.groups.empty() && surface.groups.back().site == group.site &&
                          (cell_nodes || surface.groups.back().sides == group.sides);
        if (!same) {
            surface.groups.push_back(group);
            surface.group_begin.push_back(surface.group_begin.back());
        }
        const std::size_t before = surface.indices.size();
        if (tile.kind == MeshKind::kGrains) {
            surface.indices.insert(surface.indices.end(), tile.faces[f].begin(),
                                   tile.faces[f].end());
        } else {
            append_fan(tile, f, surface.points, surface.indices, path);
        }
        surface.group_begin.back() = static_cast<int>(surface.indices.size());
        if (cell_nodes) continue;
        if (surface.cells.empty() || surface.cells.back().site != site) {
            surface.cells.push_back({site, 0});
        }
        surface.cells.back().n_triangles += static_cast<int>(surface.indices.size() - before) / 3;
    }
    return surface;
}

Surface triangles(const Tile& tile, const std::string& path) {
    Surface surface;
    surface.points = single_precision_points(tile, path);
    surface.indices = tile.faces.corners;
    surface.vertex_colour = side_lights(vertex_valences(tile));
    return surface;
}

}  // namespace

Surface make_surface(const Tile& tile, GltfNodes nodes, const std::string& path) {
    if (!faces_have_sites(tile.kind)) return triangles(tile, path);
    return cells(tile, has_cell_nodes(tile, nodes), path);
}

}  // namespace pcvt
