#pragma once

#include "mesher/delaunay/predicates.hpp"
#include "mesher/delaunay/torus_triangulation.hpp"

namespace pcvt {

/// Whether a filter in doubles is certain that the edge of h is locally Delaunay. Fast, and false
/// for most edges that cross the seam of the domain.
/// @param coordinates  2 x n, reduced basis, in [-1.5, 2.5).
bool is_certainly_delaunay(const TorusTriangulation& triangulation, const Points& coordinates,
                           const Gram& gram, int h);

/// Told of each flip: of halfedge h before and after its edge is exchanged.
class FlipObserver {
   public:
    virtual void before_flip(int h) = 0;
    virtual void after_flip(int h) = 0;
    /// A flip at this site may come soon: what is kept of it should be in the cache.
    virtual void fetch(SiteId /*site*/) const {}

   protected:
    ~FlipObserver() = default;
};

/// A triangulation under the hands of Lawson's algorithm (C. Lawson 1977; on flat surfaces:
/// A. Bobenko and B. Springborn 2007): edges that are not locally Delaunay are flipped until there
/// is none. From counter-clockwise triangles it ends with the Delaunay triangulation, and every
/// triangle stays counter-clockwise on the way.
class LawsonFlips {
   public:
    /// @param coordinates  2 x n, reduced basis; it and the triangulation must outlive this object.
    LawsonFlips(TorusTriangulation& triangulation, const Points& coordinates, const Gram& gram)
        : triangulation_(triangulation), coordinates_(coordinates), gram_(gram) {}

    Image corner_image(int h) const {
        const Corner corner = triangulation_.corner(h);
        return image(coordinates_, corner.site, corner.offset);
    }
    /// Exact.
    bool is_counter_clockwise(int triangle) const;
    /// Exact; cocircular counts as Delaunay.
    bool is_locally_delaunay(int h) const;

    /// Flips the suspects that are not locally Delaunay, then what became suspect by that.
    /// @param suspects  halfedges; empty afterwards.
    /// @returns the number of flips.
    std::int64_t flip(std::vector<int>& suspects, FlipObserver* observer = nullptr);
    /// The same with every edge a suspect.
    std::int64_t flip_all();

   private:
    std::int64_t flip_from(int first, int last, std::vector<int>& stack, FlipObserver* observer);

    TorusTriangulation& triangulation_;
    const Points& coordinates_;
    Gram gram_;
};

}  // namespace pcvt
