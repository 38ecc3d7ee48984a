#include "mesher/plane/proof/glued_faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <tuple>

#include "mesher/base/bucket_sort.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/base/law_violation.hpp"

namespace pcvt::plane {
namespace {

using std::to_string;

const char* const kSeamLaw = "(2), seam";
const char* const kHoleLaw = "(7), holes";

/// More boundary edges without partners are not compared with each other: each pair takes some 20
/// ns.
constexpr std::size_t kMostCompared = 10000;

/// Up to this many items are compared pair by pair, which takes less time than to sort them.
constexpr std::size_t kFewItems = 12;

/// A halfedge with the key that all images of its edge share.
struct Side {
    int low;
    int high;
    Offset offset;
    bool reversed;
    int halfedge;

    friend auto operator<=>(const Side&, const Side&) = default;
    bool same_edge(const Side& other) const {
        return low == other.low && high == other.high && offset == other.offset;
    }
};

class FaceGluing {
   public:
    FaceGluing(const Tile& tile, const VertexOrbits& orbits, Precision precision)
        : tile_(tile), orbits_(orbits), precision_(precision) {}

    GluedFaces glue() {
        collect_faces();
        match_sides();
        return std::move(faces_);
    }

   private:
    void collect_faces() {
        faces_.corners.reserve(tile_.faces.corners.size());
        faces_.face_of.reserve(tile_.faces.corners.size());
        std::vector<int> corners;
        for (int f = 0; f < tile_.n_faces(); ++f) {
            checkpoint_each(f);
            distinct_corners(f, corners);
            if (corners.size() < 3) continue;
            const int face = faces_.n_faces();
            faces_.file_face.push_back(f);
            faces_.add(corners);
            faces_.face_of.resize(faces_.corners.size(), face);
        }
    }

    void distinct_corners(int f, std::vector<int>& corners) {
        corners.clear();
        for (const int corner : tile_.faces[f]) {
            const int v = orbits_.first_copy[corner];
            if (corners.empty() || corners.back() != v) corners.push_back(v);
        }
        while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
        const bool dropped = static_cast<int>(corners.size()) < tile_.face_size(f);
        if (dropped && precision_ == Precision::kDouble) {
            throw_violation(kFaceLaw,
                            "face " + to_string(f) + " has the same corner twice in a row");
        }
        if (corners.size() >= 3) require_different(f, corners);
    }

    void require_different(int f, const std::vector<int>& corners) {
        if (corners.size() <= kFewItems) {
            bool different = true;
            for (std::size_t k = 1; k < corners.size(); ++k) {
                for (std::size_t l = 0; l < k; ++l) different &= corners[k] != corners[l];
            }
            if (different) return;
        }
        scratch_ = corners;
        std::sort(scratch_.begin(), scratch_.end());
        const auto twice = std::adjacent_find(scratch_.begin(), scratch_.end());
        if (twice == scratch_.end()) return;
        throw_violation(kFaceLaw, "face " + to_string(f) + " meets vertex " + to_string(*twice) +
                                      " more than once");
    }

    Side side(int h) const {
        const int from = faces_.corners[h];
        const int to = faces_.corners[faces_.next(h)];
        const int r = orbits_.representative[from];
        const int s = orbits_.representative[to];
        const Offset offset = orbits_.offset[to] - orbits_.offset[from];
        if (std::tie(r, s, offset) < std::make_tuple(s, r, -offset)) {
            return {.low = r, .high = s, .offset = offset, .reversed = false, .halfedge = h};
        }
        return {.low = s, .high = r, .offset = -offset, .reversed = true, .halfedge = h};
    }

    /// The lower of the two representatives of each side, which the sides of an edge share.
    std::vector<int> lower_ends() const {
        std::vector<int> lower(faces_.corners.size());
        for (int f = 0; f < faces_.n_faces(); ++f) {
            checkpoint_each(f);
            const int last = faces_.begin[f + 1] - 1;
            int to = orbits_.representative[faces_.corners[faces_.begin[f]]];
            for (int h = last; h >= faces_.begin[f]; --h) {
                const int from = orbits_.representative[faces_.corners[h]];
                lower[h] = std::min(from, to);
                to = from;
            }
        }
        return lower;
    }

    void match_sides() {
        faces_.opposite.assign(faces_.corners.size(), -1);
        faces_.across.resize(faces_.corners.size());
        const std::vector<int> lower = lower_ends();
        std::vector<Side> sides;
        for_each_bucket(
            faces_.n_halfedges(), tile_.n_vertices(), [&](int h) { return lower[h]; },
            [&](std::span<const int> halfedges) {
                sides.clear();
                for (const int h : halfedges) sides.push_back(side(h));
                if (match_few(sides)) return;
                std::sort(sides.begin(), sides.end());
                match(sides);
            });
        put_holes_on_walls();
        require_partners();
    }

    /// The edges of holes as the tile names them, between first copies.
    std::map<std::pair<int, int>, WallId> stated_holes() const {
        std::map<std::pair<int, int>, WallId> holes;
        const auto first = [&](int v) {
            return v >= 0 && v < tile_.n_vertices() ? orbits_.first_copy[v] : -1;
        };
        std::vector<bool> has_edge(tile_.holes.size(), false);
        for (const auto& [wall, v, w] : tile_.wall_edges) {
            if (!wall.is_hole()) continue;
            if (wall.hole() >= std::ssize(tile_.holes)) {
                throw_violation(kHoleLaw,
                                "edge " + edge_in_words(v, w) + " lies at a hole without a name");
            }
            has_edge[std::size_t(wall.hole())] = true;
            holes.emplace(std::pair(first(v), first(w)), wall);
        }
        for (std::size_t k = 0; k < has_edge.size(); ++k) {
            if (!has_edge[k]) throw_violation(kHoleLaw, "no edge lies at a hole " + tile_.holes[k]);
        }
        return holes;
    }

    void put_holes_on_walls() {
        const auto holes = stated_holes();
        if (holes.empty()) return;
        for (int h = 0; h < faces_.n_halfedges(); ++h) {
            checkpoint_each(h);
            if (faces_.opposite[h] >= 0) continue;
            const int v = faces_.corners[h];
            const int w = faces_.corners[faces_.next(h)];
            const auto found = holes.find({v, w});
            if (found == holes.end()) continue;
            faces_.put_on_wall(h);
            faces_.hole_edges.push_back({found->second, v, w});
        }
        std::sort(faces_.hole_edges.begin(), faces_.hole_edges.end());
    }

    /// Links few sides as match() does, without sorting them, if each of them has one partner,
    /// which runs in the other direction; otherwise links none.
    bool match_few(const std::vector<Side>& sides) {
        if (sides.size() > kFewItems) return false;
        std::array<std::size_t, kFewItems> partner;
        for (std::size_t k = 0; k < sides.size(); ++k) {
            int n = 0;
            for (std::size_t l = 0; l < sides.size(); ++l) {
                if (l == k || !sides[l].same_edge(sides[k])) continue;
                if (sides[l].reversed == sides[k].reversed) return false;
                partner[k] = l;
                ++n;
            }
            if (n != 1) return false;
        }
        for (std::size_t k = 0; k < sides.size(); ++k) {
            if (!sides[k].reversed) link(sides[k].halfedge, sides[partner[k]].halfedge);
        }
        return true;
    }

    /// @param sides  sorted, all sides of some edges.
    void match(const std::vector<Side>& sides) {
        for (std::size_t k = 0; k < sides.size();) {
            checkpoint_each(k);
            std::size_t end = k + 1;
            while (end < sides.size() && sides[end].same_edge(sides[k])) ++end;
            // The forward sides of an edge come first.
            for (std::size_t l = k + 1; l < end; ++l) {
                if (sides[l].reversed == sides[l - 1].reversed) {
                    refuse_overlap(sides[l - 1].halfedge, sides[l].halfedge);
                }
            }
            if (end == k + 2) link(sides[k].halfedge, sides[k + 1].halfedge);
            k = end;
        }
    }

    void link(int g, int h) {
        faces_.opposite[g] = h;
        faces_.opposite[h] = g;
        faces_.across[g] =
            orbits_.offset[faces_.corners[faces_.next(h)]] - orbits_.offset[faces_.corners[g]];
        faces_.across[h] = -faces_.across[g];
    }

    std::string edge(int h) const {
        return edge_in_words(faces_.corners[h], faces_.corners[faces_.next(h)]);
    }
    std::string face(int h) const {
        return "face " + to_string(faces_.file_face[faces_.face_of[h]]);
    }

    [[noreturn]] void refuse_overlap(int g, int h) const {
        const Offset by = orbits_.offset[faces_.corners[h]] - orbits_.offset[faces_.corners[g]];
        throw_violation(kSeamLaw, "edge " + edge(g) + " of " + face(g) + " and edge " + edge(h) +
                                      " of " + face(h) +
                                      (by == Offset{} ? " are the same edge in the same direction"
                                                      : " are images by " + offset_in_words(by) +
                                                            " that run in the same direction") +
                                      ": the faces overlap, or one of them is turned round");
    }

    void require_partners() const {
        std::vector<int> lonely;
        for (int h = 0; h < faces_.n_halfedges(); ++h) {
            checkpoint_each(h);
            if (faces_.opposite[h] < 0) lonely.push_back(h);
        }
        if (lonely.empty()) return;
        const int h = lonely.front();
        std::string what = "boundary edge " + edge(h) + " of " + face(h) +
                           " has no reversed partner by any lattice vector";
        const Lattice reduced = reduce(tile_.lattice).reduced;
        const auto [nearest, apart] = nearest_to(h, lonely, reduced);
        if (nearest >= 0) {
            what += "; the nearest is edge " + edge(nearest) + " of " + face(nearest) +
                    ", off by " + in_words(apart);
        }
        throw SeamMismatch(violation_in_words(kSeamLaw, what),
                           lonely.size() > kMostCompared ? std::numeric_limits<double>::infinity()
                                                         : largest_mismatch(lonely, reduced));
    }

    double largest_mismatch(const std::vector<int>& lonely, const Lattice& reduced) const {
        double largest = 0;
        for (const int h : lonely) {
            checkpoint();
            largest = std::max(largest, nearest_to(h, lonely, reduced).second);
        }
        return largest;
    }

    /// Returns the halfedge without a partner that comes nearest to the reverse of h, and its
    /// deviation.
    std::pair<int, double> nearest_to(int h, const std::vector<int>& lonely,
                                      const Lattice& reduced) const {
        const Vec2 from = tile_.points[faces_.corners[h]];
        const Vec2 to = tile_.points[faces_.corners[faces_.next(h)]];
        std::pair nearest(-1, std::numeric_limits<double>::infinity());
        for (const int g : lonely) {
            if (g == h) continue;
            const Vec2 start = tile_.points[faces_.corners[faces_.next(g)]] - from;
            const Vec2 end = tile_.points[faces_.corners[g]] - to;
            const Vec2 u = reduced.to_lattice(start);
            const Vec2 translation = reduced.to_position({std::round(u.x()), std::round(u.y())});
            const double apart = std::max((start - translation).lpNorm<Eigen::Infinity>(),
                                          (end - translation).lpNorm<Eigen::Infinity>());
            if (apart < nearest.second) nearest = {g, apart};
        }
        return nearest;
    }

    const Tile& tile_;
    const VertexOrbits& orbits_;
    Precision precision_;
    GluedFaces faces_;
    std::vector<int> scratch_;
};

}  // namespace

GluedFaces glue_faces(const Tile& tile, const VertexOrbits& orbits, Precision precision) {
    return FaceGluing(tile, orbits, precision).glue();
}

}  // namespace pcvt::plane
