#include "mesher/plane/delaunay/torus_triangulation.hpp"

#include <algorithm>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/base/huge_pages.hpp"
#include "mesher/plane/geometry/edge_matching.hpp"

namespace pcvt::plane {
namespace {

std::int8_t narrow(int x) {
    const auto small = static_cast<std::int8_t>(x);
    if (small != x) throw InternalError("a triangle spans more than 127 periods");
    return small;
}

std::vector<int> match_sides(const std::vector<Triangle>& triangles) {
    std::vector<DirectedEdge> halfedges;
    halfedges.reserve(3 * triangles.size());
    for (const Triangle& t : triangles) {
        for (int k = 0; k < 3; ++k) {
            const Corner& to = t[(k + 1) % 3];
            halfedges.push_back({t[k].site, to.site, to.offset - t[k].offset});
        }
    }
    return match_edges(halfedges);
}

}  // namespace

CornerOffsets packed_offsets(Offset second, Offset third) {
    return {narrow(second.i), narrow(second.j), narrow(third.i), narrow(third.j)};
}

TorusTriangulation::TorusTriangulation(int n_sites, const std::vector<Triangle>& triangles)
    : TorusTriangulation(n_sites, std::vector<SiteId>(3 * triangles.size()),
                         std::vector<CornerOffsets>(triangles.size()), match_sides(triangles)) {
    for (int t = 0; t < n_triangles(); ++t) set_triangle(t, triangles[t]);
}

TorusTriangulation::TorusTriangulation(int n_sites, std::vector<SiteId> corner_sites,
                                       std::vector<CornerOffsets> corner_offsets,
                                       std::vector<int> opposite)
    : n_sites_(n_sites),
      sites_(std::move(corner_sites)),
      opposite_(std::move(opposite)),
      offsets_(std::move(corner_offsets)) {
    if (offsets_.size() != 2 * static_cast<std::size_t>(n_sites)) {
        throw InternalError("a torus triangulation of n sites must have 2 n triangles");
    }
}

TorusTriangulation TorusTriangulation::part(int n_sites, std::vector<SiteId> corner_sites,
                                            std::vector<CornerOffsets> corner_offsets,
                                            std::vector<int> opposite) {
    TorusTriangulation part;
    part.n_sites_ = n_sites;
    part.sites_ = std::move(corner_sites);
    part.opposite_ = std::move(opposite);
    part.offsets_ = std::move(corner_offsets);
    return part;
}

void TorusTriangulation::prefer_huge_pages() const {
    pcvt::prefer_huge_pages(sites_);
    pcvt::prefer_huge_pages(opposite_);
    pcvt::prefer_huge_pages(offsets_);
}

void TorusTriangulation::set_triangle(int t, const Triangle& corners) {
    offsets_[t] = packed_offsets(corners[1].offset - corners[0].offset,
                                 corners[2].offset - corners[0].offset);
    for (int k = 0; k < 3; ++k) sites_[3 * t + k] = corners[k].site;
}

void TorusTriangulation::flip(int h) {
    // The quadrilateral a, d, b, c, where h runs from a to b, c is its apex and d the apex across.
    const int o = opposite_[h];
    const int h1 = next(h);
    const int h2 = previous(h);
    const int o1 = next(o);
    const int o2 = previous(o);
    const Corner a = corner(h);
    const Corner b = corner(h1);
    const Corner c = corner(h2);
    const Corner d = apex_across(h);

    // Link the four outer sides: h becomes d -> c with a to its left, o becomes c -> d with b to
    // its left. Each outer side keeps its opposite, which for small n may be another of the four
    // sides.
    const std::array<int, 4> before{h2, o1, o2, h1};
    const std::array<int, 4> after{h1, h2, o1, o2};
    std::array<int, 4> beyond{};
    for (int k = 0; k < 4; ++k) {
        const auto own = std::find(before.begin(), before.end(), opposite_[before[k]]);
        beyond[k] = own == before.end() ? opposite_[before[k]] : after[own - before.begin()];
    }
    for (int k = 0; k < 4; ++k) {
        opposite_[after[k]] = beyond[k];
        opposite_[beyond[k]] = after[k];
    }
    // Replace the corners of both triangles.
    const auto turned = [](int halfedge, const Corner& at, const Corner& at_next,
                           const Corner& at_previous) -> Triangle {
        switch (halfedge % 3) {
            case 0:
                return {at, at_next, at_previous};
            case 1:
                return {at_previous, at, at_next};
            default:
                return {at_next, at_previous, at};
        }
    };
    set_triangle(h / 3, turned(h, d, c, a));
    set_triangle(o / 3, turned(o, c, d, b));
}

std::array<int, 3> TorusTriangulation::insert(int triangle, Offset offset) {
    const std::array<Corner, 3> old{corner(3 * triangle), corner(3 * triangle + 1),
                                    corner(3 * triangle + 2)};
    const Corner site{n_sites_++, offset};
    const int second = n_triangles();
    const std::array<int, 3> sides{3 * triangle, 3 * second, 3 * second + 3};
    sites_.resize(sites_.size() + 6);
    opposite_.resize(opposite_.size() + 6);
    offsets_.resize(offsets_.size() + 2);
    // Link the outer sides, of which two may face each other.
    std::array<int, 3> beyond{};
    for (int k = 0; k < 3; ++k) {
        const int o = opposite_[3 * triangle + k];
        beyond[k] = o / 3 == triangle ? sides[o % 3] : o;
    }
    for (int k = 0; k < 3; ++k) {
        opposite_[sides[k]] = beyond[k];
        opposite_[beyond[k]] = sides[k];
    }
    // Link the sides between the three, and set their corners.
    for (int k = 0; k < 3; ++k) {
        const int after = sides[(k + 1) % 3];
        opposite_[sides[k] + 1] = after + 2;
        opposite_[after + 2] = sides[k] + 1;
        set_triangle(sides[k] / 3, {old[k], old[(k + 1) % 3], site});
    }
    return sides;
}

void TorusTriangulation::add_to_offsets(const std::vector<Offset>& change) {
    for (int t = 0; t < n_triangles(); ++t) {
        checkpoint_each(t);
        const Offset first = change[sites_[3 * t]];
        const Offset second = change[sites_[3 * t + 1]] - first;
        const Offset third = change[sites_[3 * t + 2]] - first;
        CornerOffsets& o = offsets_[t];
        o = {narrow(o.i1 + second.i), narrow(o.j1 + second.j), narrow(o.i2 + third.i),
             narrow(o.j2 + third.j)};
    }
}

void TorusTriangulation::renumber_sites(const std::vector<SiteId>& number) {
    for (SiteId& site : sites_) site = number[site];
}

}  // namespace pcvt::plane
