#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "mesher/plane/geometry/lattice.hpp"

namespace pcvt::bench {

/// The results of a peer that can be compared between all peers.
struct Diagram {
    /// Number of vertices, or cells, that the peer stores.
    std::int64_t n_vertices = 0;
    /// Number of triangles of the Delaunay triangulation; periodic ones count once per orbit.
    std::int64_t n_triangles = 0;
    /// The total area of all cells; only where the peer computes cells.
    std::optional<double> area;
    /// The constructed object, alive until the caller drops it, so that its destruction need not be
    /// timed.
    std::shared_ptr<const void> structure;
};

/// A peer computes one diagram from points, including the conversion of the points to the types of
/// its library (about 1 ns per site).
/// @param points  2 x n; for all peers except cgal_plain in [0, 1)^2, the unit square.
using Peer = Diagram(const plane::Points& points);

/// CGAL's Delaunay_triangulation_2 of the n points by one spatially sorted insertion, not periodic:
/// n vertices, 2 n - 2 - (corners of the convex hull) triangles. The unit of all ratios.
Diagram cgal_plain(const plane::Points& points);

/// The same for the 3 x 3 copies, the paper's reference: 9 n vertices. Triangles are counted once
/// per orbit, by their leftmost corner: 2 n.
Diagram cgal_nine_copies(const plane::Points& points);

/// CGAL's Periodic_2_Delaunay_triangulation_2 by its insertion for large sets, with dummy points: 2
/// n triangles, and n vertices in the one-sheeted cover. A hundred random sites remain in the
/// nine-sheeted cover, with 9 n vertices.
Diagram cgal_periodic(const plane::Points& points);

/// Our mirror diagram, the paper's method: n vertices, 2 n triangles.
Diagram mirrors(const plane::Points& points);

/// voro++ computes cells in space: here one layer of prisms, periodic in x and y, with the
/// thickness, the blocks and the unit of length that are best for it: n cells and, with three sides
/// at each Voronoi vertex, 2 n triangles.
Diagram voro_prisms(const plane::Points& points);

}  // namespace pcvt::bench
