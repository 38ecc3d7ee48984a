#include "mesher/torus_triangulation.hpp"

#include <algorithm>

#include "mesher/edge_matching.hpp"
#include "mesher/error.hpp"

namespace pcvt {
TorusTriangulation::TorusTriangulation(int n_sites, const std::vector<Triangle>& triangles)
    : n_sites_(n_sites) {
    if (triangles.size() != 2 * static_cast<std::size_t>(n_sites)) {
        throw InternalError("a torus triangulation of n sites must have 2 n triangles");
    }
    for (const Triangle& t : triangles) corners_.insert(corners_.end(), t.begin(), t.end());

    std::vector<DirectedEdge> halfedges;
    halfedges.reserve(corners_.size());
    for (int h = 0; h < n_halfedges(); ++h) {
        halfedges.push_back({corners_[h].site, corners_[next(h)].site, edge_offset(h)});
    }
    opposite_ = match_edges(halfedges);
}

void TorusTriangulation::flip(int h) {
    // The quadrilateral a, d, b, c with h: a -> b, c its apex and d the apex across.
    const int o = opposite_[h];
    const int h1 = next(h);
    const int h2 = previous(h);
    const int o1 = next(o);
    const int o2 = previous(o);
    const Corner a = corners_[h];
    const Corner b = corners_[h1];
    const Corner c = corners_[h2];
    const Corner d = apex_across(h);

    // h becomes d -> c, with a to its left; o becomes c -> d, with b to its left. The four outer
    // sides keep what lies beyond them, which may be another one of the four when n is small.
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
    corners_[h] = d;
    corners_[h1] = c;
    corners_[h2] = a;
    corners_[o] = c;
    corners_[o1] = d;
    corners_[o2] = b;
}

void TorusTriangulation::add_to_offsets(const std::vector<Offset>& change) {
    for (Corner& corner : corners_) corner.offset = corner.offset + change[corner.site];
}

}  // namespace pcvt
