#pragma once

#include <type_traits>
#include <variant>

#include "mesher/mesh/periodic_mesh.hpp"
#include "mesher/tile/openmesh_properties.hpp"
#include "mesher/tile/tile.hpp"

namespace pcvt {

/// An open disc: one OpenMesh mesh of one fundamental domain whose boundary halfedges are matched.
///
/// Laws, tested by number:
///   (1) The partner of a partner is the halfedge itself, and no halfedge is its own partner.
///   (2) A partner runs the other way: its from-vertex is the translate of the to-vertex.
///   (3) Positions are representative + translation, so the two sides of the seam agree to the
///       rounding of one addition.
///   (4) V - E + F = 1 as it stands and 0 after gluing.
///   (5) The face areas sum to lattice.area().
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
    /// 2: the triangles have a node in the middle of each edge as well (second_order.hpp).
    int order = 1;
    Mesh mesh;
    OpenMeshProperties identification;
};

using CellTile = OpenMeshTileOf<CellMesh>;
using TriangleTile = OpenMeshTileOf<TriangleMesh>;
using OpenMeshTile = std::variant<CellTile, TriangleTile>;

/// The tile of the faces of `periodic`, face f in the image placement[f].
///
/// Each site of a Delaunay tile is a vertex; faces of a tile of cells, or of grains, know theirs.
/// @throws InternalError if the placed faces do not form a disc.
OpenMeshTile make_tile(const PeriodicMesh& periodic, const std::vector<Offset>& placement);

/// The tile as plain arrays, for writers and for the proof.
Tile flatten(const OpenMeshTile& tile);

}  // namespace pcvt
