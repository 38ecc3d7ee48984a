#pragma once

#include <span>

#include "mesher/plane/proof/validate.hpp"

namespace pcvt::plane {

/// The vertices of a tile, grouped by the lattice.
struct VertexOrbits {
    /// For each vertex, the smallest vertex index on its orbit.
    std::vector<int> representative;
    /// position(v) = position(representative[v]) + translation(offset[v]) within the tolerance.
    std::vector<Offset> offset;
    /// For each vertex, the smallest vertex index with the same representative and offset.
    std::vector<int> first_copy;
    /// The largest distance of a vertex from its representative plus the translation, in one
    /// coordinate, length units.
    double mismatch = 0;
};

/// Groups vertices by nothing but positions and lattice, in O(n log n).
///
/// Example usage:
///   const VertexOrbits orbits = find_vertex_orbits(tile.lattice, tile.points, 1e-12);
///   const Vec2 translation = tile.lattice.translation(orbits.offset[v]);
///
/// Two vertices lie on one orbit if they are joined by a chain of vertices, where each vertex
/// agrees with the next modulo the lattice within `tolerance` in each coordinate. Offsets are in
/// the basis of `lattice`.
/// @throws NotATile if a vertex lies too many periods away from vertex 0 to count them, if the
///         tolerance is not small compared with the periods, or if the distance between the ends of
///         a chain exceeds 4 tolerances.
/// @param copies  for each of the last points, the earlier point whose position it repeats and
///                which is not a copy itself. The search skips these points.
VertexOrbits find_vertex_orbits(const Lattice& lattice, std::span<const Vec2> points,
                                double tolerance, std::span<const int> copies = {});

/// Returns the orbits that prove_tile found.
VertexOrbits proven_orbits(const TileProof& proof);

}  // namespace pcvt::plane
