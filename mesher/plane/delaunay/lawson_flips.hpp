#pragma once

#include "mesher/plane/delaunay/predicates.hpp"
#include "mesher/plane/delaunay/torus_triangulation.hpp"

namespace pcvt::plane {

/// Whether a filter in doubles certifies that the edge of h is locally Delaunay. Fast, but returns
/// false for most edges that cross the seam of the domain.
/// @param coordinates  2 x n, reduced basis, in [-1.5, 2.5).
bool is_certainly_delaunay(const TorusTriangulation& triangulation, const Points& coordinates,
                           const Gram& gram, int h);

/// Receives a call before and after each flip of an edge, with its halfedge h.
class FlipObserver {
   public:
    virtual void before_flip(int h) = 0;
    virtual void after_flip(int h) = 0;
    /// Announces that a flip at this site may follow soon, so that the observer can prefetch the
    /// site's data.
    virtual void fetch(SiteId /*site*/) const {}

   protected:
    ~FlipObserver() = default;
};

/// Lawson's algorithm on a triangulation of the torus (C. Lawson 1977; on flat surfaces: A. Bobenko
/// and B. Springborn 2007): flips edges that are not locally Delaunay until there is none. From
/// counter-clockwise triangles the algorithm ends with the Delaunay triangulation, and every
/// intermediate triangle is counter-clockwise.
///
/// Use:
///
///     LawsonFlips flips(triangulation, coordinates, gram);
///     const std::int64_t n_flips = flips.flip_all();
class LawsonFlips {
   public:
    /// @param coordinates  2 x n, reduced basis; it and the triangulation must outlive this object.
    LawsonFlips(TorusTriangulation& triangulation, const Points& coordinates, const Gram& gram)
        : triangulation_(triangulation), coordinates_(coordinates), gram_(gram) {}

    Image corner_image(int h) const {
        const Corner corner = triangulation_.corner(h);
        return image(coordinates_, corner.site, corner.offset);
    }
    /// Whether the triangle is counter-clockwise; exact.
    bool is_counter_clockwise(int triangle) const;
    /// Whether the edge of h is locally Delaunay; exact, and true for cocircular corners and on the
    /// border of a part (torus_triangulation.hpp).
    bool is_locally_delaunay(int h) const;

    /// Flips the suspects that are not locally Delaunay, then the edges that become suspects.
    /// @param suspects  halfedges; empty afterwards.
    /// @returns the number of flips.
    std::int64_t flip(std::vector<int>& suspects, FlipObserver* observer = nullptr);
    /// The same, starting with every edge as a suspect.
    std::int64_t flip_all();
    /// The same, but gives up soon after `most` flips.
    /// @returns whether no more were needed.
    bool flip_all_within(std::int64_t most);

   private:
    std::int64_t flip_edges(std::int64_t most);
    std::int64_t flip_from(int first, int last, std::vector<int>& stack, FlipObserver* observer);

    TorusTriangulation& triangulation_;
    const Points& coordinates_;
    Gram gram_;
};

}  // namespace pcvt::plane
