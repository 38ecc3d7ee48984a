#include "mesher/plane/geometry/edge_matching.hpp"

#include <algorithm>
#include <tuple>

#include "mesher/base/bucket_sort.hpp"
#include "mesher/base/error.hpp"

namespace pcvt::plane {
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

/// Pairs all sides of some edges; rejects edges without exactly two sides.
void pair_sides(std::vector<EdgeSide>& sides, std::vector<int>& opposite) {
    std::sort(sides.begin(), sides.end(), [](const EdgeSide& s, const EdgeSide& t) {
        return std::tie(s.edge, s.reversed) < std::tie(t.edge, t.reversed);
    });
    for (std::size_t k = 0; k < sides.size(); k += 2) {
        const bool paired = k + 1 < sides.size() && sides[k].edge == sides[k + 1].edge &&
                            !sides[k].reversed && sides[k + 1].reversed;
        const bool third = k + 2 < sides.size() && sides[k + 2].edge == sides[k].edge;
        if (!paired || third) throw InternalError("an edge on the torus does not have two sides");
        opposite[sides[k].halfedge] = sides[k + 1].halfedge;
        opposite[sides[k + 1].halfedge] = sides[k].halfedge;
    }
}

}  // namespace

std::vector<int> match_edges(const std::vector<DirectedEdge>& halfedges) {
    int n_vertices = 0;
    for (const DirectedEdge& e : halfedges) {
        n_vertices = std::max({n_vertices, e.origin + 1, e.target + 1});
    }
    // The two sides of an edge share its lower end.
    const auto low = [&](int h) { return std::min(halfedges[h].origin, halfedges[h].target); };
    std::vector<int> opposite(halfedges.size());
    std::vector<EdgeSide> sides;
    for_each_bucket(static_cast<int>(halfedges.size()), n_vertices, low,
                    [&](std::span<const int> bucket) {
                        sides.clear();
                        for (const int h : bucket) sides.push_back(edge_side(halfedges[h], h));
                        pair_sides(sides, opposite);
                    });
    return opposite;
}

}  // namespace pcvt::plane
