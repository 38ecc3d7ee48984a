#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "mesher/space/grains/cell_hull.hpp"
#include "mesher/space/grains/tetrahedron_shape.hpp"
#include "mesher/space/mesh/tetrahedral_mesh.hpp"

namespace pcvt::space {

using FourCorners = std::array<int, 4>;
using ThreeCorners = std::array<int, 3>;

/// Triangles of the hull that vanish with a replacement, and those that come in their place.
struct HullChange {
    std::vector<ThreeCorners> gone = {};
    std::vector<ThreeCorners> come = {};
};

/// The tetrahedra inside of one cell, while they change. Vertices 0 ... n_hull() - 1 are the points
/// of its hull, others lie inside. Numbers of tetrahedra are reused: those that are not alive have
/// no meaning.
///
/// Example usage:
///     CellTetrahedra cell(hull, *kernel_point(hull));
///     for (int t = 0; t < cell.n_numbers(); ++t) {
///         if (cell.is_alive(t)) use(cell.corners(t));
///     }
///
/// Laws, tested by number:
///   (1) Every tetrahedron is positively oriented, and they fill the hull once.
///   (2) The triangles without a neighbour are those of the hull.
///   (3) neighbour() is symmetric, across the same triangle.
class CellTetrahedra {
   public:
    /// No tetrahedron.
    CellTetrahedra() = default;
    /// Joins each triangle of the hull with a point of the kernel.
    CellTetrahedra(const CellHull& hull, const Vec3& centre);

    int n_hull() const { return n_hull_; }
    int n_vertices() const { return static_cast<int>(points_.size()); }
    int n_numbers() const { return static_cast<int>(corners_.size()); }
    bool is_alive(int t) const { return alive_[t] != 0; }
    const FourCorners& corners(int t) const { return corners_[t]; }
    /// The tetrahedron across the triangle opposite to corner k; -1 on the hull.
    int neighbour(int t, int k) const { return neighbours_[t][k]; }
    /// The smallest sine of the dihedral angles; beside a sharp feature quality_at_feature() of it.
    double quality(int t) const { return quality_[t]; }
    double quality_of(const FourCorners& c) const {
        return rated(c, smallest_sine(points_[c[0]], points_[c[1]], points_[c[2]], points_[c[3]]));
    }
    /// The quality of a tetrahedron with these corners and this smallest sine.
    double rated(const FourCorners& c, double sine) const {
        return is_at_feature(c) ? quality_at_feature(sine) : sine;
    }
    /// Whether a corner is near to a sharp feature of the cell.
    bool is_at_feature(const FourCorners& c) const {
        return !near_.empty() && (is_near(c[0]) || is_near(c[1]) || is_near(c[2]) || is_near(c[3]));
    }
    /// Takes over CellHull::near, for points of the hull that have moved.
    void set_near(const std::vector<char>& near);
    double worst() const;
    const Vec3& point(int v) const { return points_[v]; }
    /// The target length of edges at a vertex, and at a point near to these vertices.
    double size(int v) const { return sizes_[v]; }
    /// Whether a vertex is a corner of a tetrahedron.
    bool is_used(int v) const { return one_at_[v] >= 0; }
    bool is_inner(int v) const { return v >= n_hull_; }
    /// The triangle opposite to corner k, counter-clockwise seen from outside.
    ThreeCorners triangle(int t, int k) const {
        const FourCorners& c = corners_[t];
        const std::array<int, 3>& order = kOutwardSides[k];
        return {c[order[0]], c[order[1]], c[order[2]]};
    }
    /// The volume over the cube of the longest edge.
    static double flatness_of(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
    double flatness(int t) const;
    /// Whether the flatness is so small that proofs would refuse the tetrahedron.
    bool is_flat(int t) const;
    bool has_corner(int t, int v) const;
    /// The index of a corner of a tetrahedron.
    int index_of(int t, int v) const;
    Circumsphere circumsphere_of(int t) const;
    Vec3 barycentre(int t) const;

    /// Puts the tetrahedra with a corner v into `star`.
    void find_star(int v, std::vector<int>& star) const;
    /// Walks from a tetrahedron to the one that holds x; -1 if the walk leaves the hull.
    int locate(const Vec3& x, int start) const;
    /// A tetrahedron that is alive.
    int any() const;

    /// Replaces tetrahedra by others with the same boundary, except for `hull`.
    /// @throws InternalError  the boundaries differ.
    void replace(std::span<const int> old, std::span<const FourCorners> fresh,
                 const HullChange& hull = {});
    /// The numbers of the tetrahedra that the last replace() added.
    const std::vector<int>& fresh() const { return fresh_; }
    int add_vertex(const Vec3& at, double size);
    void set_size(int v, double size) { sizes_[v] = size; }
    void forget_vertex(int v) { one_at_[v] = -1; }
    void set_point(int v, const Vec3& at) { points_[v] = at; }
    void update_quality(std::span<const int> tetrahedra);

    /// Searches that are not repeated where they failed before, as long as nothing has changed.
    enum VertexSearch { kRelaxation, kMove, kContraction, kVertexSearches };
    enum TetrahedronSearch { kFlip, kInsertion, kTetrahedronSearches };
    bool has_failed(VertexSearch what, int v) const {
        return vertex_failures_[v][what] >= changes_[v];
    }
    void note_failure(VertexSearch what, int v) { vertex_failures_[v][what] = now_; }
    /// That no vertex of a tetrahedron has another star than when the search failed.
    bool has_failed(TetrahedronSearch what, int t) const {
        const FourCorners& c = corners_[t];
        return failures_[t][what] >=
               std::max({changes_[c[0]], changes_[c[1]], changes_[c[2]], changes_[c[3]]});
    }
    void note_failure(TetrahedronSearch what, int t) { failures_[t][what] = now_; }

    /// Multiplies all positions.
    void scale(double factor);
    /// Gives memory back that only changes need; further changes take it again.
    void release_memory();

    /// A mark for each tetrahedron, 0 between calls.
    std::vector<char>& marks() const { return marks_; }

   private:
    /// One side of a triangle while the tetrahedra of a replacement are linked.
    struct Side {
        int a, b, c;
        int tetrahedron;
        int k;
    };
    static Side side(const ThreeCorners& triangle, int t, int k);
    int add(const FourCorners& corners);
    void collect_boundary(std::span<const int> old, const HullChange& hull);
    void link(const Side& side);
    void note_change(const FourCorners& corners) {
        for (const int v : corners) changes_[v] = now_;
    }
    bool is_near(int v) const { return v < n_hull_ && near_[v] != 0; }

    int n_hull_ = 0;
    std::vector<char> near_;
    std::vector<Vec3> points_;
    std::vector<double> sizes_;
    /// One tetrahedron at each vertex.
    std::vector<int> one_at_;
    std::vector<FourCorners> corners_;
    std::vector<FourCorners> neighbours_;
    std::vector<double> quality_;
    std::vector<char> alive_;
    mutable std::vector<char> marks_;
    std::vector<int> free_;
    std::vector<int> fresh_;
    /// Sides that wait for their other side, by a hash of their vertices; those of an earlier
    /// replacement have another number.
    struct Slot {
        Side side;
        int replacement;
    };
    std::vector<Slot> slots_;
    int n_replacements_ = 0;
    std::size_t n_waiting_ = 0;
    /// The number of changes, and for each vertex that of the last one of its star.
    int now_ = 1;
    std::vector<int> changes_;
    std::vector<std::array<int, kVertexSearches>> vertex_failures_;
    std::vector<std::array<int, kTetrahedronSearches>> failures_;
};

}  // namespace pcvt::space
