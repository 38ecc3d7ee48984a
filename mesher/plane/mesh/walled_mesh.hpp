#pragma once

#include <optional>

#include "mesher/plane/geometry/walled_domain.hpp"
#include "mesher/plane/mesh/periodic_mesh.hpp"

namespace pcvt::plane {

/// Divides the cells whose sites lie on walls along the walls. Both parts keep the site; a mesh
/// without such cells does not change.
/// @param cells  of the torus, whole.
PeriodicMesh cut_along_walls(PeriodicMesh cells, const WalledDomain& domain);

/// For each face of the torus the offset at which it lies between the walls, or `nullopt` for
/// faces of the mirror images.
std::vector<std::optional<Offset>> places_between_walls(const PeriodicMesh& mesh,
                                                        const WalledDomain& domain);

/// Moves the vertices of edges between a face that has a place and one that has none onto the wall.
void move_onto_walls(PeriodicMesh& mesh, const std::vector<std::optional<Offset>>& places,
                     const WalledDomain& domain);

/// The faces between walls as a mesh of the domain's lattice.
///
/// Example usage:
///   const PeriodicMesh channel = mesh_between_walls(mesh, places, domain);
///   const bool on_wall = channel.opposite[c] < 0;
///
/// Faces keep their order. The opposite of an edge on a wall is -1. Every vertex has one
/// representative between the walls, and offsets across walls are 0.
PeriodicMesh mesh_between_walls(const PeriodicMesh& mesh,
                                const std::vector<std::optional<Offset>>& places,
                                const WalledDomain& domain);

/// The cells or triangles of the torus that lie between walls, cells halved along them.
///
/// Example usage:
///   const PeriodicMesh cells = part_between_walls(cell_mesh(cvt.torus.delaunay), cvt.domain);
PeriodicMesh part_between_walls(PeriodicMesh torus, const WalledDomain& domain);

/// A mesh between walls together with its mirror images at x = 0 and y = 0: a mesh of the torus
/// with mirrored_lattice(). The given faces come first; the images have the sites of their faces.
/// @param between  of the kind kVoronoi; its `opposite` is not read.
PeriodicMesh mirrored_mesh(PeriodicMesh between, const WalledDomain& domain);

/// The wall on which an edge of a mesh between walls lies.
/// @param c  mesh.opposite[c] < 0.
const WallSideRow& wall_side_of(const PeriodicMesh& mesh, int c, const WalledDomain& domain);

}  // namespace pcvt::plane
