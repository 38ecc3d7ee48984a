#include "tests/support/grid_tile.hpp"

namespace pcvt::testing {
namespace {

/// The vertices of the (columns + 1) x (rows + 1) grid and their identification, without faces.
plane::Tile grid_vertices(const plane::Lattice& lattice, plane::MeshKind kind, int columns,
                          int rows) {
    plane::Tile tile{.lattice = lattice, .kind = kind};
    const auto id = [columns](int i, int j) { return j * (columns + 1) + i; };
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i) {
            const plane::Offset offset{i / columns, j / rows};
            const plane::Vec2 u(double(i % columns) / columns, double(j % rows) / rows);
            tile.points.push_back(lattice.to_position(u) + lattice.translation(offset));
            if (offset != plane::Offset{}) {
                tile.vertex_pairs.push_back({id(i % columns, j % rows), id(i, j), offset});
            }
        }
    }
    const bool right_handed = lattice.right_handed();
    const auto glue = [&](int v0, int v1, int w0, int w1, plane::Offset offset) {
        // The face of v0 -> v1 lies to its left only in a right-handed basis.
        if (right_handed) {
            tile.edge_pairs.push_back({v0, v1, w0, w1, offset});
        } else {
            tile.edge_pairs.push_back({v1, v0, w1, w0, offset});
        }
    };
    for (int i = 0; i < columns; ++i) {
        glue(id(i, 0), id(i + 1, 0), id(i, rows), id(i + 1, rows), {0, 1});
    }
    for (int j = 0; j < rows; ++j) {
        glue(id(0, j + 1), id(0, j), id(columns, j + 1), id(columns, j), {1, 0});
    }
    return tile;
}

void add_face(plane::Tile& tile, std::vector<int> corners) {
    if (!tile.lattice.right_handed()) corners = {corners.rbegin(), corners.rend()};
    tile.faces.add(corners);
}

}  // namespace

plane::Tile grid_tile(const plane::Lattice& lattice, int columns, int rows) {
    plane::Tile tile = grid_vertices(lattice, plane::MeshKind::kVoronoi, columns, rows);
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const int v = j * (columns + 1) + i;
            add_face(tile, {v, v + 1, v + columns + 2, v + columns + 1});
            tile.face_site.push_back(j * columns + i);
            tile.site_points.push_back((tile.points[v] + tile.points[v + columns + 2]) / 2);
        }
    }
    return tile;
}

plane::Tile triangle_grid_tile(const plane::Lattice& lattice, int columns, int rows) {
    plane::Tile tile = grid_vertices(lattice, plane::MeshKind::kDelaunay, columns, rows);
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const int v = j * (columns + 1) + i;
            add_face(tile, {v, v + 1, v + columns + 2});
            add_face(tile, {v, v + columns + 2, v + columns + 1});
        }
    }
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i) {
            tile.vertex_site.push_back((j % rows) * columns + i % columns);
        }
    }
    return tile;
}

plane::Tile grain_grid_tile(const plane::Lattice& lattice, int columns, int rows) {
    plane::Tile tile = triangle_grid_tile(lattice, columns, rows);
    tile.kind = plane::MeshKind::kGrains;
    tile.vertex_site.clear();
    for (int f = 0; f < tile.n_faces(); ++f) tile.face_site.push_back(f / 2);
    return tile;
}

}  // namespace pcvt::testing
