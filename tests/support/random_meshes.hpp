#pragma once

#include <cstdint>

#include "mesher/plane/geometry/sites.hpp"
#include "mesher/plane/mesh/outline.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/tile/tile_builder.hpp"

namespace pcvt::testing {

/// The cells of random sites.
inline plane::PeriodicMesh random_cells(const plane::Lattice& lattice, int n, std::uint64_t seed) {
    return cell_mesh(
        plane::PeriodicDelaunay(plane::Sites(lattice, uniform_points(lattice, n, seed))));
}

/// A tile of whole cells or triangles of random sites.
inline plane::Tile random_tile(const plane::Lattice& lattice, int n, plane::MeshKind kind) {
    const plane::PeriodicDelaunay delaunay(plane::Sites(lattice, uniform_points(lattice, n, 4)));
    const plane::PeriodicMesh mesh =
        kind == plane::MeshKind::kVoronoi ? cell_mesh(delaunay) : triangle_mesh(delaunay);
    return make_tile(mesh, whole_outline(mesh, plane::Vec2(0, 0)));
}

}  // namespace pcvt::testing
