#include "io/forms/triangle_elements.hpp"

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"

namespace pcvt {

int owner_corner(const plane::Tile& tile, int f) {
    const auto corners = tile.faces[f];
    const plane::Vec2 centroid =
        (tile.points[corners[0]] + tile.points[corners[1]] + tile.points[corners[2]]) / 3;
    int nearest = corners[0];
    for (const int v : {corners[1], corners[2]}) {
        const double distance = (tile.points[v] - centroid).squaredNorm();
        if (distance < (tile.points[nearest] - centroid).squaredNorm()) nearest = v;
    }
    return nearest;
}

void require_triangles(plane::MeshKind kind, const std::string& path) {
    if (kind != plane::MeshKind::kVoronoi) return;
    throw InvalidInput(path + ": the format has no polygons; take the mesh delaunay or grains");
}

std::vector<SiteId> element_cells(const plane::Tile& tile) {
    if (!tile.face_site.empty()) return tile.face_site;
    std::vector<SiteId> cells;
    cells.reserve(static_cast<std::size_t>(tile.n_faces()));
    for (int f = 0; f < tile.n_faces(); ++f) {
        checkpoint_each(f);
        cells.push_back(tile.vertex_site[owner_corner(tile, f)]);
    }
    return cells;
}

}  // namespace pcvt
