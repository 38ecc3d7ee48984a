#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "mesher/lattice/lattice.hpp"

namespace pcvt::bench {

/// What a peer made of the sites, so far as all peers can be compared.
struct Diagram {
    /// Vertices, or cells, that the peer stores.
    std::int64_t n_vertices = 0;
    /// Triangles of the Delaunay triangulation; periodic ones count once an orbit.
    std::int64_t n_triangles = 0;
    /// Of all cells together; only where the peer makes cells.
    std::optional<double> area;
    /// What was built, alive until the caller drops it: destruction need not be timed.
    std::shared_ptr<const void> structure;
};

/// A peer does its whole job once, from points to diagram; the points are copied into the types of
/// its library meanwhile (about 1 ns a site).
/// @param points  2 x n; for all peers but cgal_plain in [0, 1)^2, the unit square.
using Peer = Diagram(const Points& points);

/// CGAL's Delaunay_triangulation_2 of the n points by one spatially sorted insertion, not periodic:
/// n vertices, 2 n - 2 - (corners of the convex hull) triangles. The unit of our ratios.
Diagram cgal_plain(const Points& points);

/// The same of the 3 x 3 copies, with which the paper compares: 9 n vertices. Triangles are counted
/// once an orbit, by their leftmost corner: 2 n.
Diagram cgal_nine_copies(const Points& points);

/// CGAL's Periodic_2_Delaunay_triangulation_2 by its insertion for large sets, with dummy points:
/// 2 n triangles, and n vertices in the one-sheeted cover. A hundred random sites stay in the
/// nine-sheeted one, with 9 n vertices.
Diagram cgal_periodic(const Points& points);

/// Our mirror diagram, the paper's method: n vertices, 2 n triangles.
Diagram mirrors(const Points& points);

/// voro++ makes cells in space: here one layer of prisms, periodic in x and y. It is given the
/// thickness, the blocks and the unit of length that serve it best: n cells and, three sides to a
/// Voronoi vertex, 2 n triangles.
Diagram voro_prisms(const Points& points);

}  // namespace pcvt::bench
