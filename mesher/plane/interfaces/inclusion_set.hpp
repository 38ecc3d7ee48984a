#pragma once

#include <optional>

#include "mesher/plane/interfaces/inclusion.hpp"
#include "mesher/plane/interfaces/polygon_sides.hpp"
#include "mesher/plane/interfaces/torus_grid.hpp"

namespace pcvt::plane {

/// Inclusions on the torus whose outlines neither touch nor cross each other or images of each
/// other. One shape may lie inside of another one, as a fibre inside of its coating; the innermost
/// shape at a point counts.
///
/// Example usage:
///
///     const InclusionSet set(lattice, {{Circle{{0, 0}, 0.2}, 1, 1}, {Circle{{0.5, 0.5}, 0.1}, 2,
///     2}});
///     const int k = set.containing({0.95, 0.98});  // 0: the circle crosses the corner
///     const double gap = set.distance_to_others(0, {0.2, 0}, 1);
///
/// Between walls the torus consists of the domain and its mirror images, and the set contains the
/// images of the shapes: inclusion k + r * n_given() is the mirror_image() r of inclusion k.
///
/// Laws, tested by number:
///   (1) No outline of an image meets another outline.
///   (2) containing() is the same at p and at every image of p.
///   (3) Between walls, a shape lies between them without touching one.
///   (4) parent() is the smallest of the shapes that contain a shape.
class InclusionSet {
   public:
    /// @param inclusions  anywhere in the plane; images are implied. Polygons in either
    /// orientation.
    /// @throws InvalidInput naming the lines: a size or a tag is not positive, a number not finite,
    ///         a polygon has fewer than three corners, one sharper than 3 degrees, or crosses
    ///         itself; a shape is larger than the
    ///         domain or meets an image of itself; the outlines of two shapes touch or cross; a
    ///         shape touches or crosses a wall.
    /// @param domain  upright if it has walls.
    InclusionSet(const Lattice& domain, std::vector<Inclusion> inclusions,
                 Walls walls = Walls::kNone);

    /// With the mirror images.
    int size() const { return static_cast<int>(inclusions_.size()); }
    int n_given() const { return size() / n_images(walls_); }
    const Lattice& domain() const { return domain_; }
    Walls walls() const { return walls_; }
    /// The period vectors of the torus, mirror images included.
    const Lattice& lattice() const { return lattice_; }
    const Reduction& reduction() const { return reduction_; }
    /// As given, polygons counter-clockwise.
    const Inclusion& operator[](int k) const { return inclusions_[k]; }
    /// The sides of inclusion k; none unless it is a polygon.
    const PolygonSides& sides(int k) const { return sides_[k]; }

    /// The inclusion an image of which lies around inclusion k, with none between, or -1.
    int parent(int k) const { return parents_[k]; }

    /// The innermost inclusion that contains a point, or -1.
    /// @param p  length units, anywhere.
    int containing(const Vec2& p) const;
    /// The least distance of a point from the outlines of other shapes and of other images of
    /// inclusion `own`, if it is below `reach`; else `reach`.
    /// @param p  in the frame in which `own` was given.
    double distance_to_others(int own, const Vec2& p, double reach) const;

    /// Nodes on outlines near the sides of a box, and of its images, are placed on them, so that a
    /// cut along the box makes no slivers there.
    /// @param corner  of the box, length units.
    void set_box(const Vec2& corner) { box_corner_ = corner; }
    bool has_box() const { return box_corner_.has_value(); }
    /// The coordinate of a point across the sides of a family (axis 0: those parallel to b, 1: to
    /// a), which lie at whole numbers; nullopt without a box.
    std::optional<double> box_coordinate(const Vec2& p, int axis) const {
        if (!box_corner_) return std::nullopt;
        return domain_.to_lattice(p - *box_corner_)[axis];
    }

    /// Translates a point by that lattice vector which takes it nearest to the curve of inclusion k
    /// as it was given; nullopt if no image of the shape is near.
    std::optional<Vec2> in_frame_of(int k, const Vec2& p) const;

   private:
    template <class Visit>
    void visit_images(const Vec2& p, double distance, const Visit& visit) const;
    void require_between_walls(const Inclusion& inclusion) const;
    void add_mirror_images();
    ShapeRelation relation(int i, int j, const Vec2& translation) const;
    void find_parents();
    void put_inside(int inner, int outer);
    double signed_distance_to(int k, const Vec2& p) const;

    Lattice domain_;
    Walls walls_;
    Lattice lattice_;
    Reduction reduction_;
    std::vector<Inclusion> inclusions_;
    std::vector<PolygonSides> sides_;
    std::vector<double> areas_;
    std::vector<int> parents_;
    std::vector<Circle> bounds_;
    /// The whole periods that wrap() removed from each bounding circle's centre.
    std::vector<Offset> whole_;
    double largest_radius_ = 0;
    std::optional<TorusGrid> grid_;
    std::optional<Vec2> box_corner_;
};

}  // namespace pcvt::plane
