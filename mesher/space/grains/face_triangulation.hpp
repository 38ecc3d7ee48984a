#pragma once

#include <array>
#include <vector>

#include "mesher/space/grains/ear_cutting.hpp"

namespace pcvt::space {

/// The limits above which a triangle of a face is refined.
struct FaceLimits {
    /// Of the circumradius, length units.
    double radius;
    /// The sine of the smallest angle.
    double sine;
    /// Points of the face, its boundary included.
    int most_points;
};

/// The triangles of one face, in the plane of the face.
///
/// Example usage:
///     FaceTriangulation face(boundary);
///     const std::vector<int> obstacles = face.refine(limits);
///     face.improve();
///
/// Laws, tested by number:
///   (1) The triangles are counter-clockwise, cover the polygon once, and have each of its segments
///       as an edge; no triangle has three points of one straight side.
///   (2) Every triangle after refine() keeps the limits, or the centre of its circle lies beyond a
///       segment of the boundary or in the circle over it, and refine() returns that segment.
class FaceTriangulation {
   public:
    /// Cuts ears of the widest smallest angle, then flips edges until none is in a circle.
    /// @param boundary  a convex polygon, counter-clockwise; may have points on its sides. May be
    ///                  slightly concave, where a face is not plane.
    explicit FaceTriangulation(std::vector<Point2> boundary);

    /// Inserts the centre of the largest circle of a triangle beyond the limits, until there is
    /// none.
    /// @returns  segments of the boundary, by rising number, at which an insertion stopped; segment
    ///           k runs from point k to the next point of the boundary.
    std::vector<int> refine(const FaceLimits& limits);

    /// Moves inner points and flips edges where that widens the smallest angle round them.
    void improve();

    /// Points of the boundary come first.
    const std::vector<Point2>& points() const { return points_; }
    const std::vector<std::array<int, 3>>& triangles() const { return triangles_; }
    int n_boundary() const { return n_boundary_; }

   private:
    double area2(int a, int b, int c) const;
    double sine(int a, int b, int c) const;
    void link();
    /// Flips edges of these triangles, and then of those that it changes.
    void make_delaunay(std::vector<int> stack);
    bool in_circle(int t, int point) const;
    /// The corner of the neighbour across edge k that the two do not share: its index.
    int apex_across(int t, int k) const;
    bool may_flip(int t, int k) const;
    void flip(int t, int k);
    void relink(int t, int from, int to);
    int locate(const Point2& x, int start) const;
    void insert(const Point2& x, int t);
    int encroached_segment(const Point2& x) const;
    int segment_before(const Point2& x) const;
    /// The circumradius of a triangle beyond the limits, or 0.
    double excess(int t, const FaceLimits& limits) const;
    void move_points();
    void flip_thin();

    std::vector<Point2> points_;
    int n_boundary_;
    double extent_;
    std::vector<std::array<int, 3>> triangles_;
    /// neighbours_[t][k]: the triangle across the edge opposite to corner k; -1 on the boundary.
    std::vector<std::array<int, 3>> neighbours_;
    /// The triangles that insert() changed.
    std::vector<int> changed_;
};

}  // namespace pcvt::space
