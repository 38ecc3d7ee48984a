#pragma once

#include <span>
#include <vector>

#include "mesher/space/mesh/cell_complex.hpp"

namespace pcvt::space {

/// An edge in a plane that cuts a cell: two corners in the frame of the cell, in the order in which
/// a face of the piece below the plane runs through them.
struct CutEdge {
    SiteId cell;
    int plane;
    VertexImage from;
    VertexImage to;

    friend auto operator<=>(const CutEdge&, const CutEdge&) = default;
};

/// Returns the edges that bound the pieces below the planes, ascending: each once, and without
/// those between two faces of one piece, of which one lies in the plane; these come in both
/// directions.
std::vector<CutEdge> boundaries_of(std::vector<CutEdge> edges);

/// Returns the corners of a polygon.
/// @param edges  ascending.
/// @returns nothing if they are not those of one polygon.
std::vector<VertexImage> cycle_of(std::span<const CutEdge> edges);

}  // namespace pcvt::space
