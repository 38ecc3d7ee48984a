#pragma once

#include <optional>

#include "mesher/interfaces/inclusion.hpp"
#include "mesher/interfaces/torus_grid.hpp"

namespace pcvt {

/// Inclusions on the torus that neither meet each other nor images of each other.
///
/// Example usage:
///
///     const InclusionSet set(lattice, {{Circle{{0, 0}, 0.2}, 1, 1}, {Circle{{0.5, 0.5}, 0.1}, 2,
///     2}}); const int k = set.containing({0.95, 0.98});  // 0: the circle crosses the corner of
///     the domain const double gap = set.distance_to_others(0, {0.2, 0}, 1);
///
/// Laws, tested by number:
///   (1) No image of a shape meets another image or shape.
///   (2) containing() is the same at p and at every image of p.
class InclusionSet {
   public:
    /// @param inclusions  anywhere in the plane; images are implied. Polygons in either
    /// orientation.
    /// @throws InvalidInput naming the lines: a size or a tag is not positive, a number not finite,
    ///         a polygon has fewer than three corners, one sharper than 3 degrees, or crosses
    ///         itself; a shape is larger than the
    ///         domain or meets an image of itself; two shapes meet.
    InclusionSet(const Lattice& lattice, std::vector<Inclusion> inclusions);

    int size() const { return static_cast<int>(inclusions_.size()); }
    const Lattice& lattice() const { return lattice_; }
    const Reduction& reduction() const { return reduction_; }
    /// As given, polygons counter-clockwise.
    const Inclusion& operator[](int k) const { return inclusions_[k]; }

    /// The inclusion that contains a point, or -1.
    /// @param p  length units, anywhere.
    int containing(const Vec2& p) const;
    /// The least distance of a point from the other shapes and from other images of inclusion
    /// `own`, if it is below `reach`; else `reach`.
    /// @param p  in the frame in which `own` was given.
    double distance_to_others(int own, const Vec2& p, double reach) const;

   private:
    template <class Visit>
    void visit_images(const Vec2& p, double distance, const Visit& visit) const;
    void require_apart() const;

    Lattice lattice_;
    Reduction reduction_;
    std::vector<Inclusion> inclusions_;
    std::vector<Circle> bounds_;
    /// Of each bounding circle's centre: the whole periods that wrap() removed.
    std::vector<Offset> whole_;
    double largest_radius_ = 0;
    std::optional<TorusGrid> grid_;
};

}  // namespace pcvt
