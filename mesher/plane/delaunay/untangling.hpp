#pragma once

#include <unordered_map>

#include "mesher/plane/delaunay/lawson_flips.hpp"
#include "mesher/plane/delaunay/site_moves.hpp"

namespace pcvt::plane {

/// Local repair after a move that inverted triangles; its cost depends only on the number of sites
/// that it touches.
///
/// The sites of inverted triangles return to their old positions, and so do the sites of each
/// triangle that this inverts, until there is none. Then the sites advance to their new positions
/// one by one, by halves where the whole move would invert a triangle, and Lawson's flips restore
/// the Delaunay triangulation after each step.
class Untangling final : private FlipObserver {
   public:
    /// @param moves        the moves of the sites from coordinates at which all triangles are
    ///                     counter-clockwise; where they were not, `run` gives up.
    /// @param coordinates  the moved coordinates; changed temporarily and equal at the end.
    Untangling(TorusTriangulation& triangulation, const SiteMoves& moves, Points& coordinates,
               const Gram& gram)
        : triangulation_(triangulation),
          moves_(moves),
          coordinates_(coordinates),
          flips_(triangulation, coordinates, gram) {}

    /// Repairs the triangulation.
    /// @param inverted   every triangle that is not counter-clockwise.
    /// @param suspects   halfedges of all edges that may not be locally Delaunay.
    /// @param most_held  the largest number of sites to move back before giving up.
    /// @returns false if it gave up; the triangulation must then be built from scratch.
    bool run(const std::vector<int>& inverted, std::vector<int> suspects, std::size_t most_held);
    std::int64_t n_flips() const { return n_flips_; }

   private:
    struct Held {
        SiteId site;
        Vec2 target;
    };

    void before_flip(int) override {}
    void after_flip(int h) override;
    /// Moves the corners of a triangle back to their old positions.
    /// @returns false if all of them were back already.
    bool hold(int triangle);
    /// Moves sites back until no triangle at a held site is inverted.
    /// @returns false if this needs more than `most_held` sites, or if a triangle is inverted with
    ///          all its corners at their old positions: after a failed step nothing is known about
    ///          the old state.
    bool hold_inverted_stars(std::size_t most_held);
    bool star_is_counter_clockwise(int h) const;
    std::vector<int> edges_round(SiteId site) const;
    bool advance(const Held& held);
    /// Moves all remaining sites to their new positions regardless of inverted triangles.
    void give_up();

    TorusTriangulation& triangulation_;
    const SiteMoves& moves_;
    Points& coordinates_;
    LawsonFlips flips_;
    std::int64_t n_flips_ = 0;
    std::vector<Held> held_;
    /// A halfedge that leaves each held site.
    std::unordered_map<SiteId, int> leaving_;
};

}  // namespace pcvt::plane
