#include "mesher/plane/proof/hole_polygons.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/law_violation.hpp"

namespace pcvt::plane {
namespace {

/// Walks along the edges of a hole, which lies on the right of each.
class HoleWalk {
   public:
    HoleWalk(const Tile& tile, const GluedFaces& faces, double tolerance)
        : tile_(tile), faces_(faces), tolerance_(tolerance), seen_(faces.corners.size(), false) {
        for (const WallEdge& edge : faces.hole_edges) wall_[{edge.v0, edge.v1}] = edge.wall;
    }

    std::vector<Polygon> polygons() {
        std::vector<Polygon> polygons;
        for (int h = 0; h < faces_.n_halfedges(); ++h) {
            checkpoint_each(h);
            if (is_hole(h) && !seen_[h]) polygons.push_back(polygon_from(h));
        }
        return polygons;
    }

   private:
    std::pair<int, int> edge(int h) const {
        return {faces_.corners[h], faces_.corners[faces_.next(h)]};
    }
    bool is_hole(int h) const { return faces_.on_wall(h) && wall_.contains(edge(h)); }

    [[noreturn]] void refuse(int h, const std::string& what) const {
        const auto [v, w] = edge(h);
        throw_violation("(7), holes", "the hole at edge " + edge_in_words(v, w) + ", on " +
                                          wall_name(tile_, wall_.at({v, w})) + ", " + what);
    }

    /// Moves on to the next edge of the hole: round the end of h, over faces.
    /// @param offset  of the face of h; it becomes that of the next face.
    int next_edge(int h, Offset& offset) const {
        int g = faces_.next(h);
        while (!faces_.on_wall(g)) {
            offset = offset - faces_.across[g];
            g = faces_.next(faces_.opposite[g]);
        }
        return g;
    }

    Polygon polygon_from(int first) {
        Polygon polygon;
        Offset offset{};
        const WallId wall = wall_.at(edge(first));
        int h = first;
        do {
            if (!is_hole(h)) refuse(first, "meets another wall");
            if (wall_.at(edge(h)) != wall) refuse(h, "has two names");
            seen_[h] = true;
            polygon.push_back(tile_.points[faces_.corners[h]] + tile_.lattice.translation(offset));
            h = next_edge(h, offset);
        } while (h != first);
        if (offset != Offset{}) refuse(first, "goes round the torus");
        std::reverse(polygon.begin(), polygon.end());
        if (!(polygon_area(polygon) > 0) || crosses_itself(polygon, tolerance_)) {
            refuse(first, "is not a simple polygon");
        }
        return polygon;
    }

    const Tile& tile_;
    const GluedFaces& faces_;
    double tolerance_;
    std::vector<bool> seen_;
    std::map<std::pair<int, int>, WallId> wall_;
};

}  // namespace

std::vector<Polygon> hole_polygons(const Tile& tile, const GluedFaces& faces, double tolerance) {
    return HoleWalk(tile, faces, tolerance).polygons();
}

}  // namespace pcvt::plane
