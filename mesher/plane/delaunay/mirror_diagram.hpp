#pragma once

#include <optional>
#include <vector>

#include "mesher/plane/delaunay/torus_triangulation.hpp"

namespace pcvt::plane {

/// The part of one image's Voronoi cell within the fundamental domain of the reduced basis.
struct Piece {
    SiteId site;
    Offset offset;
    /// Corners counter-clockwise, coordinates of the reduced basis in [0, 1]^2.
    std::vector<Vec2> polygon;
};

/// The periodic Voronoi diagram from a Euclidean diagram (paper, section III), and its dual.
///
///   paper | code
///   D_0   | the half-open parallelogram [0, 1)^2 of the reduced basis
///   e_k   | its sides
///   v_k   | its corners
///   x_i,j | the image (i, offset)
///
/// Example usage:
///
///     const MirrorDiagram diagram = mirror_diagram(sites, WithPieces::kYes);
///     for (const Piece& piece : diagram.pieces) draw(piece.site, piece.polygon);
struct MirrorDiagram {
    /// The 2 n Delaunay triangles with circumcentres in D_0: one of each orbit, in an order that
    /// the platform does not change.
    std::vector<Triangle> triangles;
    /// Sorted by (site, offset); empty without WithPieces::kYes.
    std::vector<Piece> pieces;
    /// Number of images inserted in addition to the n sites.
    int n_mirrors = 0;
    /// Number of sites tagged in the paper's second step, before any mirror is inserted.
    int n_boundary_sites = 0;
    /// Number of inner sites whose cell a mirror nevertheless cuts. According to the paper there
    /// are none.
    int n_shrunk_inner_sites = 0;
};

enum class WithPieces { kNo, kYes };

/// The paper's method: Delaunay triangulation of the sites, then mirrors by flooding.
///
/// A piece in D_0 of the image (i, o) that meets the side or corner towards the neighbouring domain
/// t requires the image (i, o - t); images are inserted until none is missing. Exact ties are
/// broken by a rule that is the same for all images. The cost is one Delaunay triangulation plus
/// about 3.6 sqrt(n) insertions.
/// @throws InternalError if the number of triangles is not 2 n.
/// @throws InternalError if the triangles do not add up to 2 n.
MirrorDiagram mirror_diagram(const Sites& sites, WithPieces with_pieces = WithPieces::kNo);

/// The same where at most `most_mirrors` images suffice, as for sites that are spread evenly; else
/// nullopt, before most of the work.
std::optional<MirrorDiagram> mirror_diagram_within(const Sites& sites, int most_mirrors);

/// Only the first step: the Euclidean Delaunay triangulation of the n sites, the reference for the
/// cost of the other methods.
/// @returns the number of its triangles.
std::size_t euclidean_delaunay(const Sites& sites);

/// The slow reference method: triangulates all 3 x 3 copies of the sites.
MirrorDiagram full_copies_diagram(const Sites& sites, WithPieces with_pieces = WithPieces::kNo);

}  // namespace pcvt::plane
