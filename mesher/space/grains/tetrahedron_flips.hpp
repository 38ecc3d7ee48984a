#pragma once

#include <array>
#include <vector>

#include "mesher/space/grains/cell_tetrahedra.hpp"

namespace pcvt::space {

/// The largest number of vertices round an edge that flips take away.
inline constexpr int kMostRingVertices = 10;

/// Tetrahedra to be replaced by others with the same vertices, and the smallest sine before and
/// after.
struct FlipPlan {
    std::vector<int> old = {};
    std::vector<FourCorners> fresh = {};
    double before = 0;
    double after = 0;
};

/// Replaces tetrahedra where that raises the smallest sine.
///
/// Example usage:
///     TetrahedronFlips flips(cell);
///     if (cell.quality(t) < 0.5) flips.flip_at(t);
class TetrahedronFlips {
   public:
    explicit TetrahedronFlips(CellTetrahedra& cell) : cell_(cell) {}

    /// Removes an edge of a tetrahedron, or puts an edge in the place of one of its triangles,
    /// whichever gains first.
    /// @returns whether the tetrahedron was replaced.
    bool flip_at(int t);

    /// Finds the tetrahedra round the edge (a, b) of the hull, which triangles (a, b, c) and
    /// (a, b, d) of the hull share, in order to replace it by the edge (c, d).
    /// @returns false if they are too many.
    bool find_ring_on_hull(int a, int b, int c, int d, FlipPlan& plan);
    /// Plans the best tetrahedra in the place of the last ones that find_ring_on_hull() found.
    /// @returns false if their smallest sine is not above `least`.
    bool fill_ring_on_hull(double least, FlipPlan& plan);

   private:
    bool remove_edge(int t, int i, int j);
    bool remove_triangle(int t, int k);
    /// Follows the tetrahedra round an edge (a, b) in the plan, from the vertex ring_[0].
    bool close_ring(int start, int a, int b, int first, int second, FlipPlan& plan);
    bool open_ring(int start, int a, int b, int last, FlipPlan& plan);
    /// Finds the triangulation of the ring whose tetrahedra with a and b have the largest smallest
    /// sine, if that is above `least`, by a dynamic program over runs of the ring.
    bool triangulate_ring(int a, int b, double least, FlipPlan& plan);
    double pair_quality(int a, int b, int i, int k, int j, double least) const;
    int fourth(int t, int a, int b, int c) const;

    CellTetrahedra& cell_;
    std::vector<int> ring_;
    std::array<int, 2> edge_ = {};
    std::vector<int> star_;
    FlipPlan plan_;
};

}  // namespace pcvt::space
