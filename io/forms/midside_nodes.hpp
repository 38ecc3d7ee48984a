#pragma once

#include <optional>
#include <vector>

#include "io/forms/file_tile_builder.hpp"

namespace pcvt {

/// An edge of a mesh of six-node triangles with the node in its middle.
struct MidsideNode {
    int low;
    int high;
    int node;
    /// The line of a triangle that it belongs to.
    int line;
    int n_faces;
};

/// The edges of six-node triangles by rising ends. Node 3 + k of a face lies between its corners k
/// and k + 1.
/// @pre each face of `file` has six corners that exist.
/// @throws BadFile  with the line: an edge has two middle nodes, or a node is in the middle of two
///                  edges or a corner as well.
std::vector<MidsideNode> file_midside_nodes(const FileTileBuilder& file);

/// Makes a tile of six-node triangles one of three-node triangles: the middle nodes go, with their
/// pairs and sites, once they are proved to lie in the middle of their edges, and, where pairs are
/// stored, to be paired over the seam, each within 4 ulps of the largest coordinate.
/// @param lattice  replaces one that the file lacks.
/// @throws BadFile  with the line, also where file_midside_nodes() does.
void remove_midside_nodes(FileTileBuilder& file, const std::optional<plane::Lattice>& lattice,
                          plane::Precision precision);

}  // namespace pcvt
