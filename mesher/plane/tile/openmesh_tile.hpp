#pragma once

#include <type_traits>
#include <variant>

#include "mesher/plane/tile/openmesh_properties.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt::plane {

/// An open disc: one OpenMesh mesh of one fundamental domain whose boundary halfedges are matched.
///
/// Example usage:
///   const OpenMeshTile any = openmesh_tile(make_tile(cells, whole_outline(cells, {0, 0})));
///   const auto& tile = std::get<CellTile>(any);
///   for (const auto h : tile.mesh.halfedges()) {
///       const int partner = tile.mesh.property(tile.identification.partner, h);
///   }
///
/// Laws, tested by number:
///   (1) The partner of a partner is the halfedge itself, and no halfedge is its own partner.
///   (2) A partner runs the other way: its from-vertex is the translate of the to-vertex.
///   (3) Handles are the indices of the arrays: vertex v, face f.
template <class Mesh>
struct OpenMeshTileOf {
    static constexpr MeshKind kUsualKind =
        std::is_same_v<Mesh, CellMesh> ? MeshKind::kVoronoi : MeshKind::kDelaunay;

    /// An empty mesh with the properties attached and the lattice noted.
    explicit OpenMeshTileOf(const Lattice& period, MeshKind of = kUsualKind)
        : lattice(period), kind(of) {
        identification.attach(mesh);
        mesh.property(identification.lattice) = {period.a().x(), period.a().y(), period.b().x(),
                                                 period.b().y()};
    }

    Lattice lattice;
    MeshKind kind;
    /// As Tile::order.
    int order = 1;
    Mesh mesh;
    OpenMeshProperties identification;
};

using CellTile = OpenMeshTileOf<CellMesh>;
using TriangleTile = OpenMeshTileOf<TriangleMesh>;
using OpenMeshTile = std::variant<CellTile, TriangleTile>;

/// Converts arrays to an OpenMesh structure: polygons for Voronoi cells, triangles for the other
/// kinds.
/// @throws InvalidInput if OpenMesh cannot hold the faces, because they do not form a surface (then
///         OpenMesh writes a line to std::cerr, too), name vertices that do not exist, or are not
///         triangles where the kind has them; if the pairs do not match each boundary edge with
///         exactly one other; or if the tile has copies of vertices.
OpenMeshTile openmesh_tile(const Tile& tile);

/// Converts an OpenMesh structure to arrays. openmesh_tile() and tile() are inverse to each other
/// for tiles whose edge pairs are in the order of make_tile().
/// @throws InvalidInput with the handle, if the properties contradict each other: a boundary
///         halfedge without a partner, or whose partner has another one or another offset; an orbit
///         that is not a vertex or not its own representative; a mesh with deleted elements.
Tile tile(const OpenMeshTile& mesh);

}  // namespace pcvt::plane
