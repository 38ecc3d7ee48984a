#pragma once

#include <cstdint>

#include "mesher/lattice/sites.hpp"
#include "mesher/mesh/outline.hpp"
#include "mesher/mesh/voronoi.hpp"
#include "mesher/tile/tile_builder.hpp"

namespace pcvt::testing {

/// The cells of random sites.
inline PeriodicMesh random_cells(const Lattice& lattice, int n, std::uint64_t seed) {
    return cell_mesh(PeriodicDelaunay(Sites(lattice, uniform_points(lattice, n, seed))));
}

/// A tile of whole cells or triangles of random sites.
inline Tile random_tile(const Lattice& lattice, int n, MeshKind kind) {
    const PeriodicDelaunay delaunay(Sites(lattice, uniform_points(lattice, n, 4)));
    const PeriodicMesh mesh =
        kind == MeshKind::kVoronoi ? cell_mesh(delaunay) : triangle_mesh(delaunay);
    return make_tile(mesh, whole_outline(mesh, Vec2(0, 0)));
}

}  // namespace pcvt::testing
