#include "io/gltf/gltf_surface.hpp"

#include <cmath>
#include <map>
#include <utility>

#include "io/tiles/palette.hpp"
#include "mesher/base/error.hpp"
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

std::vector<Point32> single_precision(const Tile& tile, const std::string& path) {
    std::vector<Point32> points;
    points.reserve(tile.points.size());
    for (const Vec2& p : tile.points) {
        // Adding zero turns -0 into 0.
        points.push_back({static_cast<float>(p.x()) + 0.0f, static_cast<float>(p.y()) + 0.0f});
        if (!std::isfinite(points.back()[0]) || !std::isfinite(points.back()[1])) {
            throw InvalidInput(path + ": coordinates too large for float32, which glTF stores; " +
                               "write another format");
        }
    }
    return points;
}

void add_fan(const Tile& tile, int face, const std::vector<int>& corners, Surface& surface,
             const std::string& path) {
    std::vector<Point32> polygon;
    for (const int v : corners) polygon.push_back(surface.points[v]);
    const std::vector<FanTriangle> fan = triangle_fan(polygon);
    if (fan.empty()) {
        throw InvalidInput(path + ": the cell of site " + std::to_string(tile.face_site[face]) +
                           " has no area in float32, which glTF stores; write another format or " +
                           "bring the tile nearer to the origin");
    }
    for (const FanTriangle& triangle : fan) {
        for (const int corner : triangle) surface.indices.push_back(corners[corner]);
    }
    surface.face_begin.push_back(static_cast<int>(surface.indices.size()));
}

std::vector<int> corners_of(const Tile& tile, int face) {
    return {tile.faces[face].begin(), tile.faces[face].end()};
}

/// Returns cells that share the vertices of the tile.
Surface separate_cells(const Tile& tile, const std::string& path) {
    Surface surface;
    surface.points = single_precision(tile, path);
    for (int f = 0; f < tile.n_faces(); ++f) {
        add_fan(tile, f, corners_of(tile, f), surface, path);
    }
    return surface;
}

/// Returns cells with vertices of their own: the first cell at a vertex keeps it, every other cell
/// gets a copy.
Surface joined_cells(const Tile& tile, const std::string& path) {
    // A vertex without a cell has site -1.
    Surface surface;
    surface.points = single_precision(tile, path);
    surface.vertex_site.assign(surface.points.size(), -1);
    surface.vertex_colour.assign(surface.points.size(), {});
    const std::vector<Point3> lights = side_lights(cell_sides(tile));
    for (int f = 0; f < tile.n_faces(); ++f) {
        // Copy the corners that an earlier cell has.
        std::vector<int> corners = corners_of(tile, f);
        for (int& v : corners) {
            if (surface.vertex_site[v] >= 0) {
                surface.copies.push_back(v);
                surface.points.push_back(surface.points[v]);
                surface.vertex_site.push_back(-1);
                surface.vertex_colour.emplace_back();
                v = static_cast<int>(surface.points.size()) - 1;
            }
            surface.vertex_site[v] = static_cast<float>(tile.face_site[f]);
            surface.vertex_colour[v] = lights[f];
        }
        add_fan(tile, f, corners, surface, path);
    }
    return surface;
}

/// Returns triangles that share vertices within their grain: the first grain at a vertex keeps it,
/// every other grain gets a copy.
Surface grains(const Tile& tile, const std::string& path) {
    // A vertex without a grain has site -1.
    Surface surface;
    surface.points = single_precision(tile, path);
    surface.face_begin = tile.faces.begin;
    surface.vertex_site.assign(surface.points.size(), -1);
    surface.vertex_colour.assign(surface.points.size(), {});
    const std::vector<Point3> lights = side_lights(cell_sides(tile));
    // Find the vertex of each corner in its grain, or make a copy.
    std::map<std::pair<int, SiteId>, int> copies;
    for (std::size_t c = 0; c < tile.faces.corners.size(); ++c) {
        const int v = tile.faces.corners[c];
        const SiteId site = tile.face_site[c / 3];
        const bool is_first = surface.vertex_site[v] < 0;
        const bool owns = is_first || surface.vertex_site[v] == static_cast<float>(site);
        const int next = static_cast<int>(surface.points.size());
        const int own = owns ? v : copies.try_emplace({v, site}, next).first->second;
        if (own == next) {
            surface.copies.push_back(v);
            surface.points.push_back(surface.points[v]);
            surface.vertex_site.push_back(-1);
            surface.vertex_colour.emplace_back();
        }
        // All triangles of the grain give the vertex the same site and colour.
        surface.vertex_site[own] = static_cast<float>(site);
        surface.vertex_colour[own] = lights[c / 3];
        surface.indices.push_back(own);
    }
    return surface;
}

Surface triangles(const Tile& tile, const std::string& path) {
    Surface surface;
    surface.points = single_precision(tile, path);
    surface.indices = tile.faces.corners;
    surface.face_begin = tile.faces.begin;
    surface.vertex_site.assign(tile.vertex_site.begin(), tile.vertex_site.end());
    surface.vertex_colour = side_lights(vertex_valences(tile));
    return surface;
}

}  // namespace

Surface make_surface(const Tile& tile, int max_shared, const std::string& path) {
    if (tile.kind == MeshKind::kDelaunay) return triangles(tile, path);
    if (tile.kind == MeshKind::kGrains) return grains(tile, path);
    return tile.n_faces() <= max_shared ? separate_cells(tile, path) : joined_cells(tile, path);
}

}  // namespace pcvt
