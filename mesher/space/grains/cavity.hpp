#pragma once

#include <vector>

#include "mesher/space/grains/cell_tetrahedra.hpp"

namespace pcvt::space {

/// The tetrahedra that the insertion of a vertex replaces: those whose spheres hold it, as far as
/// it sees all of their boundary (Bowyer and Watson), so that the hull of the cell remains.
///
/// Example usage:
///     Cavity cavity(cell);
///     if (cavity.find(x, cell.locate(x, t)) && cavity.has_room(0.65, 0.45, 1)) cavity.fill(size);
///
/// Laws, tested by number:
///   (1) Each tetrahedron that fill() makes is positively oriented, and no vertex vanishes.
///   (2) in_sphere() is positive for the tetrahedra that find() adds to the one that holds x.
class Cavity {
   public:
    explicit Cavity(CellTetrahedra& cell) : cell_(cell) {}

    /// The least volume of a new tetrahedron over the cube of the longest edge of its triangle:
    /// 1e10 times the rounding, or, for flat ones that become less flat, 1e4 times.
    enum class Sight { kWide, kFar };
    /// Finds the cavity of x from the tetrahedron that holds it.
    /// @returns false if there is none: x lies too near to a triangle that must stay.
    bool find(const Vec3& x, int holder, Sight sight = Sight::kWide);
    /// The least CellTetrahedra::flatness_of() of the tetrahedra that fill() would make.
    double flatness() const;
    /// The target size at x, from those of the vertices round the cavity, at most `largest`.
    double size(double largest) const;
    /// Whether x is at least this far from all vertices round the cavity, and from the triangles of
    /// the hull that belong to its boundary; length units.
    bool has_room(double from_vertices, double from_hull) const;
    /// Inserts x.
    void fill(double size);

   private:
    struct Triangle {
        ThreeCorners corners;
        bool on_hull;
    };
    void grow(int holder);
    /// Takes tetrahedra away until x sees the whole boundary.
    bool shrink(int holder);
    /// Lists the boundary, and unmarks the first tetrahedron with a triangle that x does not see,
    /// of a large cavity all of them. Sets `blocked` if one of them must stay.
    /// @returns whether there is one; then the list is not complete.
    bool remove_unseen(int holder, bool& blocked);
    /// Lists the sides of a tetrahedron on the boundary, up to one that x does not see; `blocked`
    /// is set if that one is on the hull.
    bool sees_sides_of(int t, bool& blocked);
    void keep_component(int holder);
    bool keeps_vertices();

    CellTetrahedra& cell_;
    Vec3 x_ = Vec3::Zero();
    double least_volume6_ = 0;
    std::vector<int> inside_;
    std::vector<int> kept_;
    std::vector<Triangle> boundary_;
    std::vector<FourCorners> fresh_;
    /// For each vertex the last look at a boundary that saw it.
    std::vector<long> seen_;
    long n_looks_ = 0;
};

}  // namespace pcvt::space
