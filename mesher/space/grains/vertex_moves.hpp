#pragma once

#include <vector>

#include "mesher/space/grains/cell_tetrahedra.hpp"

namespace pcvt::space {

/// The lattice directions of a pattern search in space.
inline constexpr int kSearchDirections = 14;
Vec3 search_direction(int k);

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
    bool is_better(int v, const Vec3& at, double least, double ratio) const;
    double worst_with(int v, const Vec3& at, double least) const;

    CellTetrahedra& cell_;
    std::vector<int> star_;
};

}  // namespace pcvt::space
