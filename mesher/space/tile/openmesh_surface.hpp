#pragma once

#include <vector>

#include "mesher/plane/tile/openmesh_properties.hpp"
#include "mesher/space/tile/tile_surface.hpp"

namespace pcvt::space {

/// The boundary of a tile of polyhedra as an OpenMesh structure: a closed polygon mesh whose faces
/// are matched.
///
/// Example usage:
///   const OpenMeshSurface surface = openmesh_surface(tile_surface(mesh));
///   for (const auto f : surface.mesh.faces()) {
///       const int partner = surface.mesh.property(surface.partner, f);
///   }
///
/// Names in `.om` files: "pcvt_face_partner", "pcvt_face_offset", "pcvt_face_cell" and, of the
/// mesh, "pcvt_lattice" (ax, ay, az, bx, by, bz, cx, cy, cz) and "pcvt_sites" (x0, y0, z0, x1,
/// ...).
struct OpenMeshSurface {
    /// An empty mesh with the properties attached.
    OpenMeshSurface();

    /// Handles are the indices of the arrays: vertex v, face f.
    plane::CellMesh mesh;
    /// The face that a face becomes by its translation, as a face index.
    OpenMesh::FPropHandleT<int> partner;
    /// (i, j, k) of that translation, i a + j b + k c.
    OpenMesh::FPropHandleT<OpenMesh::Vec3i> offset;
    /// The cell behind a face.
    OpenMesh::FPropHandleT<int> cell;
    OpenMesh::MPropHandleT<std::vector<double>> lattice;
    /// The sites of all cells, in their order; empty if they are not stated.
    OpenMesh::MPropHandleT<std::vector<double>> sites;
};

/// Converts arrays to an OpenMesh structure.
/// @throws InvalidInput if the faces form no manifold (then OpenMesh writes a line to std::cerr,
///         too).
OpenMeshSurface openmesh_surface(const TileSurface& surface);

/// Converts an OpenMesh structure to arrays. The two functions are inverse to each other.
/// @throws InvalidInput if `lattice` holds no nine numbers of a lattice, or `sites` no triples.
TileSurface tile_surface(const OpenMeshSurface& surface);

}  // namespace pcvt::space
