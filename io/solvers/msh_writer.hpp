#pragma once

#include <string>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/forms/entity_mesh.hpp"

namespace pcvt {

/// Encodes a mesh as Gmsh MSH 4.1 in ASCII with double precision.
///
/// Node v + 1 is node v of the mesh, element e + 1 is element e; the elements of sides have the
/// numbers after them, in the order of the file. The block of an entity lists the nodes that lie on
/// it. $ElementData "cell_id" holds the site of the cell of each element, and "orbit" the orbit of
/// that site, and -1 for sides; $NodeData "cell_id" holds the site of each node. $Comments hold the
/// kind, the lattice, and the notes. $Entities, groups and links are those of entity_mesh().
///
/// Example usage:
///     for (const EncodedFile& file : encode_msh(entity_mesh(tile), "tile.msh")) {
///         output.stage(file.path, file.bytes);
///     }
///
/// @throws InternalError  if a coordinate is not finite.
std::vector<EncodedFile> encode_msh(const EntityMesh& form, const std::string& path);

}  // namespace pcvt
