#pragma once

#include <array>

#include "mesher/sites.hpp"

namespace pcvt {

/// A corner of a triangle: the image of a site, offset in the reduced basis.
struct Corner {
    SiteId site;
    Offset offset;
};
using Triangle = std::array<Corner, 3>;

/// A triangulation of the torus as a Delta-complex in flat arrays; topology only.
///
/// An edge may join a site to its own image and two edges may join the same two sites, so n = 1 is
/// a triangulation like any other (2 triangles, 3 edges). Halfedge 3 t + k leaves corner k of
/// triangle t; corners run counter-clockwise; each triangle has a frame of its own for its offsets.
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
    TorusTriangulation(int n_sites, const std::vector<Triangle>& triangles);

    int n_sites() const { return n_sites_; }
    int n_triangles() const { return static_cast<int>(corners_.size()) / 3; }
    int n_halfedges() const { return static_cast<int>(corners_.size()); }

    static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
    static int previous(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
    int opposite(int h) const { return opposite_[h]; }
    /// The corner that h leaves.
    const Corner& corner(int h) const { return corners_[h]; }
    /// Target minus origin of h.
    Offset edge_offset(int h) const { return corners_[next(h)].offset - corners_[h].offset; }
    /// What to add to an offset in the frame of opposite(h)'s triangle to get it in that of h's.
    Offset frame_across(int h) const {
        return corners_[h].offset - corners_[next(opposite_[h])].offset;
    }
    /// The corner beyond h, in the frame of h's triangle.
    Corner apex_across(int h) const {
        const Corner& apex = corners_[previous(opposite_[h])];
        return {apex.site, apex.offset + frame_across(h)};
    }

    /// Replaces the diagonal h of the quadrilateral made by its two triangles with the other one; h
    /// and its opposite become the two sides of the new edge.
    void flip(int h);
    /// Adds change[s] to the offset of every corner at site s.
    void add_to_offsets(const std::vector<Offset>& change);

   private:
    int n_sites_;
    std::vector<Corner> corners_;
    std::vector<int> opposite_;
};

}  // namespace pcvt
