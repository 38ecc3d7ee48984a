#pragma once

namespace pcvt {

/// Voronoi cells or pieces of them; Delaunay triangles; triangles inside of cells, the grains.
enum class MeshKind { kVoronoi, kDelaunay, kGrains };

/// Whether each face belongs to a site; else each vertex is one.
constexpr bool faces_have_sites(MeshKind kind) { return kind != MeshKind::kDelaunay; }

}  // namespace pcvt
