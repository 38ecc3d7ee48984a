#pragma once

#include <unordered_map>

#include "mesher/delaunay/lawson_flips.hpp"
#include "mesher/delaunay/site_moves.hpp"

namespace pcvt {

/// Repair after a move that turned triangles over, at a cost that depends on what it touches only.
///
/// The sites of inverted triangles are put back to where they came from, and so are those of each
/// triangle that this inverts, until there is none. Then the sites travel to their new places one
/// by one, by halves where the whole way would invert a triangle, and Lawson's flips restore the
/// Delaunay triangulation after each step.
class Untangling final : private FlipObserver {
   public:
    /// @param moves        what the sites made from coordinates at which the triangles should be
    ///                     counter-clockwise; where they were not, run gives up.
    /// @param coordinates  those of the moved sites; changed on the way, the same in the end.
    Untangling(TorusTriangulation& triangulation, const SiteMoves& moves, Points& coordinates,
               const Gram& gram)
        : triangulation_(triangulation),
          moves_(moves),
          coordinates_(coordinates),
          flips_(triangulation, coordinates, gram) {}

    /// @param inverted   every triangle that is not counter-clockwise.
    /// @param suspects   halfedges of all edges that may not be locally Delaunay.
    /// @param most_held  gives up rather than put more sites than this back.
    /// @returns false where it gave up; the triangulation is then to be built anew.
    bool run(const std::vector<int>& inverted, std::vector<int> suspects, std::size_t most_held);
    std::int64_t n_flips() const { return n_flips_; }

   private:
    struct Held {
        SiteId site;
        Vec2 target;
    };

    void before_flip(int) override {}
    void after_flip(int h) override;
    /// Puts the corners back; @returns false where all of them were back already.
    bool hold(int triangle);
    /// @returns false where more sites than that would be put back, or where a triangle is inverted
    ///          with all its corners put back: after a step that failed nothing is known of
    ///          where it began.
    bool hold_inverted_stars(std::size_t most_held);
    bool star_is_counter_clockwise(int h) const;
    std::vector<int> edges_round(SiteId site) const;
    bool advance(const Held& held);
    /// Puts the sites that did not arrive to their new places all the same.
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

}  // namespace pcvt
