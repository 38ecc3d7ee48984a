#pragma once

#include <vector>

#include "mesher/space/mesh/cell_complex.hpp"

namespace pcvt::space {

/// An edge of the cells, once for all its images, and the points that divide it.
struct CellEdge {
    VertexImage from;
    VertexImage to;
    /// The target length of its parts, length units, before that of its ends.
    double size;
    /// Where it is divided, rising in (0, 1).
    std::vector<double> cuts = {};
    /// The faces that have it as an edge; one that has two images of it occurs twice.
    std::vector<int> faces = {};
};

/// An edge of a face: image `offset` of an edge of the cells.
struct EdgeUse {
    int edge;
    Offset offset;
    bool reversed;
};

/// The edges of the cells and the size of elements at their vertices.
struct CellEdges {
    std::vector<CellEdge> edges = {};
    /// For each corner of CellComplex::corners, the edge from there to the next corner of the face.
    std::vector<EdgeUse> uses = {};
    /// For each vertex the smallest length near it, and no more than the sizes of its cells: of the
    /// edges that end there, and from it to the other edges of its faces. Length units.
    std::vector<double> vertex_size = {};
};

/// The growth of the target size with the distance from a smaller feature.
inline constexpr double kSizeGrowth = 0.6;

/// Finds the edges of the cells and divides each into parts, of the length of `size` in its middle
/// and shorter towards small features.
///
/// Laws, tested by number:
///   (1) Each edge of a face is the image of one edge; its ends are the corners of the face.
///   (2) No part is longer than about the size of a cell at it.
///   (3) The parts at a vertex are no longer than about its size, however small.
///
/// @param cell_size  the target length of the edges of elements in each cell, length units.
CellEdges cell_edges(const CellComplex& complex, const std::vector<double>& cell_size);

}  // namespace pcvt::space
