#pragma once

#include <vector>

#include "mesher/space/delaunay/torus_tetrahedra.hpp"

namespace pcvt::space {

/// A periodic Delaunay triangulation into which sites are inserted one by one, each with all of its
/// images, for sites on a line, in a plane, on a sphere or in a cluster: spheres may extend by
/// several periods. growing_tetrahedra.hpp is ten times as fast where they do not.
///
/// In the universal cover, the tetrahedra whose spheres contain one image of the new site are its
/// cavity. Where spheres are large, cavities of several images overlap. So the star of the image is
/// found first: its tetrahedra join the facets of its own cavity to it (A. Bowyer, D. Watson 1981);
/// then the other images whose cavities share a tetrahedron or a facet with its own are inserted
/// into this star, as points into a convex hull. All new tetrahedra are those of the star, one of
/// each orbit. Decisions are those of predicates.hpp, its rule for ties included.
///
/// Example usage:
///
///     GrowingOrbits growing(gram, coordinates, start);  // of the first sites
///     for (SiteId s = start.n_sites(); s < n; ++s) growing.insert(s);
///     const TorusTetrahedra torus(n, growing.tetrahedra());
class GrowingOrbits {
   public:
    /// The largest diameter of a sphere, in each reduced coordinate, for which
    /// differences of images are exact.
    static constexpr double kLargestExtent = 3.5;

    /// @param coordinates  of all sites, 3 x n, reduced basis, multiples of 2^-50 in [0, 1).
    /// @param start        the triangulation of the first sites; no sphere extends by more than
    ///                     kLargestExtent. New sites keep it so.
    GrowingOrbits(const Gram& gram, const Points& coordinates, const TorusTetrahedra& start);

    /// Inserts a site.
    /// @returns false, and changes nothing, if it coincides with another.
    /// @throws LimitExceeded if there would be more tetrahedra than an int counts facets of.
    bool insert(SiteId site);

    int n_tetrahedra() const { return static_cast<int>(cells_.size() - gaps_.size()); }
    /// One of each orbit, in any frame and order.
    std::vector<Tetrahedron> tetrahedra() const;

   private:
    /// A small offset, in three bytes.
    struct Step {
        std::int8_t i = 0;
        std::int8_t j = 0;
        std::int8_t k = 0;

        Step() = default;
        explicit Step(Offset o);
        Offset offset() const { return {i, j, k}; }
    };
    /// A tetrahedron, positively oriented, or a gap. Facets have the numbers of TorusTetrahedra.
    struct Cell {
        std::array<SiteId, 4> site;
        std::array<int, 4> opposite;
        /// The offset of each corner, in the frame of the cell.
        std::array<Step, 4> corner;
        /// The offset to add when changing from the frame of the cell across a facet to this one.
        std::array<Step, 4> frame;

        bool is_gap() const { return site[0] < 0; }
    };
    /// A translate of a cell that the present insertion has met.
    struct Lifted {
        int cell;
        Offset shift;
        bool is_inside;
        /// The translate of the same cell that was met before, or -1.
        int before;
    };
    /// A facet of the star's boundary, seen from the new site: with the site as the fourth corner,
    /// the corners are positively oriented.
    using StarFacet = std::array<Corner, 3>;
    /// One side of a facet that waits for the other: the facet as all its translates have it, and
    /// the offset of its first corner.
    struct Side {
        std::array<std::uint64_t, 3> key;
        int cell;
        int facet;
        Offset base;
    };

    Displacement from_new_site(const Corner& corner) const;
    Corner corner(const Cell& cell, int k, Offset shift) const {
        return {cell.site[k], cell.corner[k].offset() + shift};
    }
    std::array<Displacement, 4> corners_of(int cell, Offset shift) const;
    int exit_of(int cell, Offset shift) const;
    bool find_first(int& cell, Offset& shift) const;
    bool contains_new_site(int cell, Offset shift) const;
    int find_lifted(int cell, Offset shift) const;
    int add_lifted(int cell, Offset shift, bool is_inside);
    void find_cavity(int cell, Offset shift);
    std::vector<Offset> near_images() const;
    void insert_into_star(Offset image);
    /// Collects the side k of a cell as that of `cell`, whose frame has the offset.
    void add_side(const Cell& c, int k, int cell, int cell_side, Offset frame);
    void remove_cavity();
    void add_star();
    int number_of_new_cell();
    void link_sides();
    void forget();

    Gram gram_;
    const Points& coordinates_;
    std::vector<Cell> cells_;
    std::vector<int> gaps_;
    int last_cell_ = 0;
    Vec3 new_site_ = Vec3::Zero();
    SiteId new_number_ = -1;

    /// The translates that the present insertion has met, and the last one of each cell, or -1.
    std::vector<Lifted> lifted_;
    std::vector<int> last_lifted_;
    std::vector<StarFacet> star_;
    std::vector<Side> sides_;
};

}  // namespace pcvt::space
