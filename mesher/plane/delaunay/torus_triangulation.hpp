#pragma once

#include <Eigen/Core>
#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "mesher/base/prefetch.hpp"
#include "mesher/plane/geometry/sites.hpp"

namespace pcvt::plane {

/// A corner of a triangle: the image of a site, offset in the reduced basis.
struct Corner {
    SiteId site;
    Offset offset;

    friend auto operator<=>(const Corner&, const Corner&) = default;
};
using Triangle = std::array<Corner, 3>;

/// The offsets of corners 1 and 2 relative to corner 0 of a triangle, in four bytes.
struct CornerOffsets {
    std::int8_t i1 = 0;
    std::int8_t j1 = 0;
    std::int8_t i2 = 0;
    std::int8_t j2 = 0;

    friend bool operator==(const CornerOffsets&, const CornerOffsets&) = default;
    bool all_zero() const { return Eigen::numext::bit_cast<std::uint32_t>(*this) == 0; }
};

/// Packs the offsets of corners 1 and 2 relative to corner 0.
/// @throws InternalError if one of them exceeds 127 periods.
CornerOffsets packed_offsets(Offset second, Offset third);

/// A triangulation of the torus as a Delta-complex in flat arrays; topology only.
///
/// An edge may join a site to its own image, and several edges may join the same two sites, so n =
/// 1 needs no special case (2 triangles, 3 edges). Halfedge 3 t + k leaves corner k of triangle t;
/// corners run counter-clockwise. Offsets are relative to the frame of their triangle, in which
/// corner 0 has offset (0, 0). 28 bytes per triangle.
///
/// Laws, tested by number:
///   (1) opposite is an involution without fixed points.
///   (2) A halfedge and its opposite join the same two images: edge_offset(opposite(h)) is
///       -edge_offset(h), with origins and targets exchanged.
///   (3) n_triangles = 2 n_sites, so V - E + F = 0.
///   (4) A flip followed by a flip of the same halfedge restores every triangle, as a set.
class TorusTriangulation {
   public:
    /// Links triangles along equal edges.
    /// @throws InternalError unless each edge has exactly two sides and there are 2 n triangles.
    ///         Every member function also throws it where offsets within a triangle differ by more
    ///         than 127.
    TorusTriangulation(int n_sites, const std::vector<Triangle>& triangles);
    /// Takes triangles with known links: the sites of the 6 n corners, the offsets of the 2 n
    /// triangles, and opposite[h] for each of the 6 n halfedges.
    TorusTriangulation(int n_sites, std::vector<SiteId> corner_sites,
                       std::vector<CornerOffsets> corner_offsets, std::vector<int> opposite);
    /// A part of such a triangulation, for which laws (1) and (3) do not hold: a halfedge on its
    /// border is its own opposite. Flips inside of the part leave the border as it is.
    static TorusTriangulation part(int n_sites, std::vector<SiteId> corner_sites,
                                   std::vector<CornerOffsets> corner_offsets,
                                   std::vector<int> opposite);

    int n_sites() const { return n_sites_; }
    int n_triangles() const { return static_cast<int>(offsets_.size()); }
    int n_halfedges() const { return static_cast<int>(sites_.size()); }

    static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
    static int previous(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
    int opposite(int h) const { return opposite_[h]; }
    /// Prefetches opposite(h).
    void fetch_opposite(int h) const { prefetch(&opposite_[h]); }
    /// Prefetches all data of h's triangle.
    void fetch_triangle(int h) const {
        fetch_opposite(h);
        prefetch(&sites_[h]);
        prefetch(&offsets_[h / 3]);
    }
    /// The corner that h leaves.
    Corner corner(int h) const { return {sites_[h], offset(h)}; }
    /// Target minus origin of h.
    Offset edge_offset(int h) const { return offset(next(h)) - offset(h); }
    /// The offset to add when changing from the frame of opposite(h)'s triangle to that of h's.
    Offset frame_across(int h) const { return offset(h) - offset(next(opposite_[h])); }
    /// The corner opposite to h in the adjacent triangle, in the frame of h's triangle.
    Corner apex_across(int h) const {
        const int apex = previous(opposite_[h]);
        return {sites_[apex], offset(apex) + frame_across(h)};
    }
    /// Whether a corner of h's triangle has an offset other than (0, 0).
    bool has_offsets(int h) const { return !offsets_[h / 3].all_zero(); }
    /// The next halfedge counter-clockwise round the site that h leaves.
    int next_round_site(int h) const { return opposite_[previous(h)]; }

    /// The sites of all corners, three per triangle, and the offsets of all triangles.
    std::span<const SiteId> corner_sites() const { return sites_; }
    std::span<const CornerOffsets> corner_offsets() const { return offsets_; }

    /// See huge_pages.hpp.
    void prefer_huge_pages() const;

    /// Replaces the diagonal h of the quadrilateral formed by its two triangles with the other
    /// diagonal; h and its opposite become the two sides of the new edge.
    void flip(int h);
    /// Divides a triangle into three at a new site, the number of which is n_sites(); the offset of
    /// its image in the triangle is in the triangle's frame.
    /// @returns the halfedges of the sides of the triangle, which now have the new site opposite to
    ///          them, in the order of its corners.
    std::array<int, 3> insert(int triangle, Offset offset);
    /// Adds change[s] to the offset of every corner at site s.
    void add_to_offsets(const std::vector<Offset>& change);
    /// Renumbers site s as number[s], a permutation of 0 ... n - 1.
    void renumber_sites(const std::vector<SiteId>& number);

   private:
    TorusTriangulation() = default;
    Offset offset(int h) const {
        const CornerOffsets& o = offsets_[h / 3];
        const int k = h % 3;
        if (k == 0) return {};
        return k == 1 ? Offset{o.i1, o.j1} : Offset{o.i2, o.j2};
    }
    void set_triangle(int t, const Triangle& corners);

    int n_sites_ = 0;
    std::vector<SiteId> sites_;
    std::vector<int> opposite_;
    std::vector<CornerOffsets> offsets_;
};

}  // namespace pcvt::plane
