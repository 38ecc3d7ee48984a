#pragma once

#include <vector>

#include "mesher/space/grains/vertex_moves.hpp"

namespace pcvt::space {

/// Adds and removes inner vertices round tetrahedra with small angles, where that raises the
/// smallest sine.
///
/// Example usage:
///     VertexInsertion insertion(cell, moves);
///     insertion.mend(t);
class VertexInsertion {
   public:
    VertexInsertion(CellTetrahedra& cell, VertexMoves& moves) : cell_(cell), moves_(moves) {}

    /// Contracts an inner vertex of a tetrahedron into a neighbour, or else inserts one in its
    /// middle, into its longest edge, or inward from its triangles on the hull.
    /// @returns whether anything was changed.
    bool mend(int t);

   private:
    bool contract(int v);
    double quality_after(int v, int into, double least) const;
    bool insert_at(int t, const Vec3& x, const std::vector<int>& holders);
    bool insert_near(int t);
    bool insert_into_longest_edge(int t);
    /// A triangle that bounds `inside_`: the quality of its tetrahedron with the new vertex, and
    /// the tetrahedron beyond, or -1.
    struct Side {
        double quality;
        int beyond;
    };
    void add_to_front(const Vec3& x, int t);
    bool grow(const Vec3& x, double least);
    bool find_boundary(int v);
    void finish(int v);

    CellTetrahedra& cell_;
    VertexMoves& moves_;
    std::vector<int> star_;
    std::vector<int> inside_;
    std::vector<Side> front_;
    std::vector<int> vertices_;
    std::vector<FourCorners> fresh_;
};

}  // namespace pcvt::space
