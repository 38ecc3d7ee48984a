#pragma once

#include <utility>
#include <vector>

#include "mesher/space/grains/star_shape.hpp"

namespace pcvt::space {

/// Moves of inner vertices of a cell. The smallest sine of a star never falls.
///
/// Example usage:
///     VertexMoves moves(cell);
///     moves.relax();
///     for (int v = cell.n_hull(); v < cell.n_vertices(); ++v) {
///         if (cell.is_used(v)) moves.climb(v, 0.5);
///     }
class VertexMoves {
   public:
    explicit VertexMoves(CellTetrahedra& cell) : cell_(cell) {}

    /// Moves each inner vertex to the mean of the circumcentres or of the barycentres of its star,
    /// weighted by volume, where that raises the mean volume-length ratio and no angle falls below
    /// 30 degrees or its present value (optimal Delaunay triangulation).
    void relax();

    /// Raises the smallest sine round an inner vertex by a pattern search.
    /// @param target  nothing moves if no sine is below it.
    /// @returns whether the vertex moved.
    bool climb(int v, double target);

   private:
    void relax_vertex(int v);
    std::pair<Vec3, double> middle_of_star(int v) const;

    CellTetrahedra& cell_;
    std::vector<int> star_;
    StarShape shape_;
};

}  // namespace pcvt::space
