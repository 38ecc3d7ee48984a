#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <vector>

#include "mesher/base/prefetch.hpp"
#include "mesher/space/delaunay/predicates.hpp"

namespace pcvt::space {

/// Corners by which orientation() is positive.
using Tetrahedron = std::array<Corner, 4>;

/// The offsets of corners 1, 2 and 3 relative to corner 0 of a tetrahedron, in nine bytes.
struct TetrahedronOffsets {
    std::array<std::int8_t, 9> relative{};

    friend bool operator==(const TetrahedronOffsets&, const TetrahedronOffsets&) = default;
    /// Most are. Two loads take less time than a call of memcmp.
    bool all_zero() const {
        std::uint64_t first = 0;
        std::memcpy(&first, relative.data(), sizeof first);
        return first == 0 && relative[8] == 0;
    }
};

/// A triangulation of the 3-torus as a Delta-complex in flat arrays; topology only.
///
/// Several tetrahedra, facets or edges may have the same sites, and an edge may join a site to its
/// own image, so n = 1 needs no special case (6 tetrahedra, 12 facets, 7 edges). Facet 4 t + k is
/// the one opposite to corner k of tetrahedron t. Offsets are relative to the frame of their
/// tetrahedron, in which corner 0 has offset (0, 0, 0).
///
/// Example usage (the images round a facet):
///
///     for (int f = 0; f < t.n_facets(); ++f) {
///         const std::array<Corner, 3> triangle = t.facet(f);  // frame of tetrahedron f / 4
///         const Corner above = t.corner(f), below = t.apex_across(f);
///     }
///
/// Laws, tested by number:
///   (1) opposite is an involution without fixed points.
///   (2) A facet and its opposite have the same three images: those of facet(opposite(f)) plus
///       frame_across(f) are those of facet(f), in another order.
///   (3) V - E + F - T = 0, and the tetrahedra, all positively oriented, fill the torus once.
class TorusTetrahedra {
   public:
    /// Links tetrahedra along equal facets.
    /// @param tetrahedra  one of each orbit, any frame.
    /// @throws InternalError unless each facet has exactly two sides. Every member function also
    ///         throws it where offsets within a tetrahedron differ by more than 127.
    TorusTetrahedra(int n_sites, const std::vector<Tetrahedron>& tetrahedra);
    /// Takes tetrahedra that are linked already: the sites of their corners and the opposites of
    /// their facets, four a tetrahedron, for which the laws hold.
    TorusTetrahedra(int n_sites, std::vector<SiteId> corner_sites, std::vector<int> opposite,
                    std::vector<TetrahedronOffsets> offsets);

    int n_sites() const { return n_sites_; }
    int n_tetrahedra() const { return static_cast<int>(offsets_.size()); }
    int n_facets() const { return static_cast<int>(sites_.size()); }

    /// The corners of facet k of a tetrahedron, in the order for which the fourth corner, k, lies
    /// on the positive side.
    static constexpr std::array<std::array<int, 3>, 4> kFacetCorners{
        {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}}};

    int opposite(int f) const { return opposite_[f]; }
    void fetch_opposite(int f) const { prefetch(&opposite_[f]); }
    /// Corner f % 4 of tetrahedron f / 4.
    [[gnu::always_inline]] Corner corner(int f) const { return {sites_[f], offset(f)}; }
    Tetrahedron tetrahedron(int t) const {
        return {corner(4 * t), corner(4 * t + 1), corner(4 * t + 2), corner(4 * t + 3)};
    }
    /// In the frame of the tetrahedron of f and in the order of kFacetCorners.
    std::array<Corner, 3> facet(int f) const;
    /// The offset to add when changing from the frame of opposite(f)'s tetrahedron to that of f's.
    Offset frame_across(int f) const;
    /// The corner opposite to f in the adjacent tetrahedron, in the frame of f's tetrahedron.
    Corner apex_across(int f) const {
        const int apex = opposite_[f];
        return {sites_[apex], offset(apex) + frame_across(f)};
    }

    /// The sites of all corners, four per tetrahedron, and the offsets of all tetrahedra.
    std::span<const SiteId> corner_sites() const { return sites_; }
    std::span<const TetrahedronOffsets> corner_offsets() const { return offsets_; }

    /// A tetrahedron, and the offset to add to its corners.
    struct Placed {
        int number;
        Offset frame;
    };
    /// The largest number of tetrahedra that replace() takes, and the largest that it adds.
    static constexpr int kMostReplaced = 4;
    /// Replaces tetrahedra by others that fill the same polyhedron, all in one frame; neither may
    /// have a corner inside of it.
    /// @param changed  gets the numbers of all tetrahedra that are new, in their order, then of
    ///                 those that have another number than before.
    /// @returns false if an old tetrahedron occurs twice, so that nothing was replaced.
    bool replace(std::span<const Placed> old, std::span<const Tetrahedron> fresh,
                 std::vector<int>& changed);

    /// Renumbers the tetrahedra by their smallest sites. Where neighbouring sites have close
    /// numbers, so have neighbouring tetrahedra then, which replacements scatter.
    void sort();
    /// Adds change[s] to the offset of every corner at site s.
    void add_to_offsets(const std::vector<Offset>& change);
    /// Renumbers site s as number[s], a permutation of 0 ... n - 1.
    void renumber_sites(const std::vector<SiteId>& number);

   private:
    Offset offset(int f) const {
        if (f % 4 == 0) return {};
        const std::int8_t* const o = &offsets_[f / 4].relative[3 * (f % 4 - 1)];
        return {o[0], o[1], o[2]};
    }
    void set_tetrahedron(int t, const Tetrahedron& corners);
    void link(int f, int o) {
        opposite_[f] = o;
        opposite_[o] = f;
    }
    /// Moves the last tetrahedra to the numbers from n_fresh on, and notes their new numbers.
    void close_gaps(std::vector<int>& numbers, std::size_t n_fresh);
    void move_last_to(int t);

    int n_sites_;
    std::vector<SiteId> sites_;
    std::vector<int> opposite_;
    std::vector<TetrahedronOffsets> offsets_;
};

/// Puts tetrahedra, one of each orbit, into the one order that does not depend on how they were
/// found: of each, the least corner (by site, then by offset) comes first, with the offset (0, 0,
/// 0), and the least of the others second; tetrahedra are sorted.
void put_in_canonical_order(int n_sites, std::vector<Tetrahedron>& tetrahedra);

/// Pairs the facets of tetrahedra that are equal up to a translation.
/// @returns the opposite of each facet, or nullopt unless each has exactly one.
std::optional<std::vector<int>> match_facets(int n_sites,
                                             const std::vector<Tetrahedron>& tetrahedra);

}  // namespace pcvt::space
