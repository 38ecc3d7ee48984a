#pragma once

namespace pcvt {

/// `kVoronoi`: Voronoi cells or pieces of them. `kDelaunay`: Delaunay triangles. `kGrains`:
/// triangles inside the cells, which are then called grains.
enum class MeshKind { kVoronoi, kDelaunay, kGrains };

/// Whether each face belongs to a site; otherwise each vertex is a site.
constexpr bool faces_have_sites(MeshKind kind) { return kind != MeshKind::kDelaunay; }

}  // namespace pcvt
