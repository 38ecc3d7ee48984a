#pragma once

#include "mesher/space/mesh/cell_complex.hpp"

namespace pcvt::space {

/// The largest CellComplex::short_edges of a run: an edge of a truncated octahedron has 0.45 h.
inline constexpr double kLongestShortEdge = 0.1;

/// Where the vertex lies to which an edge shrinks.
enum class ShrinkRule {
    /// In the middle.
    kMiddle,
    /// In the middle or at an end: where the sharpest corner of the faces there is widest. An edge
    /// remains if that corner would be below 15 degrees and sharper than before.
    kWideCorners,
};

/// Removes short edges from a Voronoi diagram of the 3-torus: shrinks each edge shorter than
/// `shortest` h to one vertex, the shortest first, until no further edge may be
/// removed. Triangles round a removed edge vanish with it.
///
/// Example usage:
///   const CellComplex cells = cell_complex(sites, tetrahedra);
///   const PolyhedralMesh smooth = polyhedral_mesh(sites, without_short_edges(cells, 1e-3));
///
/// An edge may be removed if each cell at one of its ends remains a polyhedron
/// (is_polyhedron()), keeps at least half of its volume, and has its centroid nearer to its own
/// site than to those of its neighbours, and if no vertex of the diagram comes to lie further than
/// `shortest` h from where it was. Laws, tested by number:
///   (1) The cells fill the torus as before: V - E + F - cells = 0, and the volumes sum to that of
///       the domain. Faces remain those of the same cells.
///   (2) No remaining edge shorter than `shortest` h may be removed.
///   (3) A vertex moves only if it lies on a removed edge, and by at most `shortest` h.
///   (4) With kWideCorners, no face gets a corner below 15 degrees that is sharper than all that
///       its neighbourhood had before.
///       Edges below 0.001 h that each would make such a corner, and together none, are removed
///       together, and shrink to their middles.
///   (5) The cells remain those of their sites (prove_cell_sites()), also where sites form clusters
///       whose cells are smaller than `shortest` h.
///
/// @param shortest  a part of h, the mean spacing of the sites, at most kLongestShortEdge; 0
///                  leaves the diagram as it is.
/// @param rule      kWideCorners for cells that are filled with tetrahedra, whose angles follow the
///                  corners of faces.
CellComplex without_short_edges(CellComplex complex, double shortest,
                                ShrinkRule rule = ShrinkRule::kMiddle);

}  // namespace pcvt::space
