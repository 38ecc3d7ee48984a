#include "mesher/lattice/edge_matching.hpp"

#include <algorithm>
#include <tuple>

#include "mesher/base/bucket_sort.hpp"
#include "mesher/base/error.hpp"

namespace pcvt {
namespace {

/// A halfedge with the key of its edge, which both halfedges share.
struct EdgeSide {
    std::tuple<int, int, Offset> edge;
    int halfedge;
    bool reversed;
};

EdgeSide edge_side(const DirectedEdge& e, int halfedge) {
    const std::tuple forward(e.origin, e.target, e.offset);
    const std::tuple backward(e.target, e.origin, -e.offset);
    return forward < backward ? EdgeSide{forward, halfedge, false}
                              : EdgeSide{backward, halfedge, true};
}

}  // namespace

std::vector<int> match_edges(const std::vector<DirectedEdge>& halfedges) {
    // Give every halfedge the key of its edge.
    std::vector<EdgeSide> sides;
    sides.reserve(halfedges.size());
    int n_vertices = 0;
    for (const DirectedEdge& e : halfedges) {
        sides.push_back(edge_side(e, static_cast<int>(sides.size())));
        n_vertices = std::max({n_vertices, e.origin + 1, e.target + 1});
    }
    // Sort, so that the two sides of an edge follow each other.
    bucket_sort(
        sides, n_vertices, [](const EdgeSide& side) { return std::get<0>(side.edge); },
        [](const EdgeSide& s, const EdgeSide& t) {
            return std::tie(s.edge, s.reversed) < std::tie(t.edge, t.reversed);
        });
    // Pair the sides, and reject edges without exactly two of them.
    std::vector<int> opposite(sides.size());
    for (std::size_t k = 0; k < sides.size(); k += 2) {
        const bool paired = k + 1 < sides.size() && sides[k].edge == sides[k + 1].edge &&
                            !sides[k].reversed && sides[k + 1].reversed;
        const bool third = k + 2 < sides.size() && sides[k + 2].edge == sides[k].edge;
        if (!paired || third) throw InternalError("an edge on the torus does not have two sides");
        opposite[sides[k].halfedge] = sides[k + 1].halfedge;
        opposite[sides[k + 1].halfedge] = sides[k].halfedge;
    }
    return opposite;
}

}  // namespace pcvt
