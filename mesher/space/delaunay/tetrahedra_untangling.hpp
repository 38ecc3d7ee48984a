#pragma once

#include <unordered_map>

#include "mesher/space/delaunay/tetrahedra_flips.hpp"

namespace pcvt::space {

/// Restores a triangulation in which moves have inverted tetrahedra, without a new build.
///
/// The corners of inverted tetrahedra go back to positions at which the triangulation was valid,
/// and so do the corners of tetrahedra that this inverts, until there is none. Then the sites
/// advance to their new positions one by one, by halves where the whole move would invert a
/// tetrahedron, and flips restore the Delaunay triangulation after each step.
///
/// Example usage:
///
///     TetrahedraUntangling untangling(tetrahedra, valid, coordinates, gram);
///     if (!untangling.run(inverted, suspects.facets, most_held)) rebuild();
class TetrahedraUntangling {
   public:
    /// @param valid        coordinates at which all tetrahedra are positive; where they are not,
    ///                     `run` gives up.
    /// @param coordinates  the moved coordinates; changed temporarily and equal at the end.
    TetrahedraUntangling(TorusTetrahedra& tetrahedra, const Points& valid, Points& coordinates,
                         const Gram& gram);

    /// Repairs the triangulation.
    /// @param inverted   every tetrahedron that is not positive.
    /// @param facets     all facets that may not be locally Delaunay.
    /// @param most_held  the largest number of sites to move back before giving up.
    /// @returns false if it gave up; the triangulation must then be built from scratch.
    bool run(const std::vector<int>& inverted, std::vector<int> facets, std::size_t most_held);
    std::int64_t n_flips() const { return flips_.n_flips(); }
    /// The tetrahedra that the repair replaced; this object forgets them.
    ExchangedTetrahedra take_exchanged() { return flips_.take_exchanged(); }

   private:
    struct Held {
        SiteId site;
        Vec3 target;
    };

    /// Moves the corners of a tetrahedron back to their valid positions.
    /// @returns false if all of them were back already.
    bool hold(int tetrahedron);
    /// Moves sites back until no tetrahedron at a held site is inverted.
    /// @returns false if this needs more than `most_held` sites, or if a tetrahedron is inverted
    ///          at the valid positions.
    bool hold_inverted_stars(std::size_t most_held);
    /// Adds the facets of a star.
    static void append_facets(const std::vector<int>& star, std::vector<int>& facets);
    bool all_positive(const std::vector<int>& star) const;
    bool advance(const Held& held);
    /// Moves all remaining sites to their new positions regardless of inverted tetrahedra.
    void give_up();
    void note_changed(const std::vector<int>& changed);

    TorusTetrahedra& tetrahedra_;
    const Points& valid_;
    Points& coordinates_;
    TetrahedraFlips flips_;
    std::vector<Held> held_;
    /// A corner at each held site, as 4 t + k.
    std::unordered_map<SiteId, int> corner_at_;
};

/// Lists the corners of tetrahedra, as 4 t + k, that are the same image of a site as one corner is,
/// up to translations.
std::vector<int> star_of_corner(const TorusTetrahedra& tetrahedra, int corner);

}  // namespace pcvt::space
