#pragma once

#include <vector>

#include "mesher/space/delaunay/torus_tetrahedra.hpp"

namespace pcvt::space {

/// A periodic Delaunay triangulation into which sites are inserted one by one (A. Bowyer 1981,
/// D. Watson 1981): the tetrahedra whose circumspheres contain the new site are replaced by those
/// that join the facets of their union to it.
///
/// Every circumsphere must extend by less than half a period in each reduced coordinate. Then no
/// sphere contains two images of a site, the images of a tetrahedron's corners follow from their
/// coordinates, so that no offset is stored, and new sites keep it so: a sphere that contains no
/// site is never larger than the largest one before. Decisions are those of predicates.hpp,
/// its rule for ties included.
///
/// Example usage:
///
///     GrowingTetrahedra growing(gram, coordinates, start);  // of the first sites
///     for (SiteId s = start.n_sites(); s < n; ++s) growing.insert(s);
class GrowingTetrahedra {
   public:
    /// A tetrahedron, positively oriented, or a gap. Facets have the numbers of TorusTetrahedra.
    struct Cell {
        std::array<SiteId, 4> site;
        std::array<int, 4> opposite;

        bool is_gap() const { return site[0] < 0; }
    };

    /// @param coordinates  of all sites, 3 x n, reduced basis, multiples of 2^-50 in [0, 1).
    /// @param start        the triangulation of the first sites, with spheres as above.
    GrowingTetrahedra(const Gram& gram, const Points& coordinates, const TorusTetrahedra& start);

    /// Inserts a site.
    /// @returns false, and changes nothing, if it coincides with another.
    bool insert(SiteId site);

    const std::vector<Cell>& cells() const { return cells_; }

   private:
    /// A site near the new one.
    struct Neighbour {
        SiteId site;
        /// Whether the nearest image might not be the one that a tetrahedron has as a corner.
        bool is_far;
        /// From the new site to the nearest image, and its squared length.
        Displacement displacement;
        double height;
    };
    /// A facet of the cavity, seen from within: the places of its corners among the neighbours, the
    /// facet of the tetrahedron behind it, and the new tetrahedron on it.
    struct Wall {
        std::array<int, 3> corner;
        int behind;
        int cell;
    };
    using Corners = std::array<Displacement, 4>;
    /// Whether a cell lies in the cavity of the present insertion, as far as that is known.
    enum class Side : std::uint8_t { kUnknown, kInside, kOutside };

    Displacement from_new_site(SiteId site) const;
    Corners corners_from_new_site(const Cell& cell) const;
    double height(const Displacement& d) const { return gram_.squared_length(d.x, d.y, d.z); }
    bool contains_new_site(const Corners& corners, const std::array<double, 4>& heights) const;
    bool contains_new_site(const Corners& corners) const;
    bool can_be_first(int t) const;
    int exit_of(int t) const;
    int find_first() const;
    int find_by_walk() const;
    int find_by_search() const;
    int place_of(SiteId site);
    int add_neighbour(SiteId site);
    bool is_in_conflict(int facet);
    bool is_in_conflict_across_seam(int facet) const;
    void find_cavity(int first);
    void add_wall(int facet);
    void fill_cavity();
    int number_of_new_cell();
    void link_by_table();
    void link_by_sorting();

    Gram gram_;
    const Points& coordinates_;
    double most_determinant_error_;
    double most_in_sphere_error_;
    std::vector<Cell> cells_;
    std::vector<int> gaps_;
    int last_cell_ = 0;
    Vec3 new_site_ = Vec3::Zero();
    SiteId new_number_ = -1;

    std::vector<Side> side_;
    std::vector<int> cavity_;
    std::vector<int> outside_;
    /// The sites that the present insertion has met, and the place of each site among them, if it
    /// is one.
    std::vector<Neighbour> neighbours_;
    std::vector<int> place_;
    std::vector<Wall> walls_;
    /// The facet beside each directed edge between two places.
    std::vector<int> beside_;
};

}  // namespace pcvt::space
