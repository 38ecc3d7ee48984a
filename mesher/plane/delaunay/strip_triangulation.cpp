#include "mesher/plane/delaunay/strip_triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "mesher/base/checkpoint.hpp"

namespace pcvt::plane {
namespace {

/// A vertex of the strip: an image with absolute coordinates, that across the columns first.
struct StripVertex {
    SiteId site;
    Offset offset;
    Vec2 point;
    bool on_right;
};

/// Orders points upwards, and along a horizontal line to the right.
bool below(const Vec2& p, const Vec2& q) {
    return p.y() < q.y() || (p.y() == q.y() && p.x() < q.x());
}

/// Whether the filter certifies that p, q, r turn counter-clockwise.
bool surely_counter_clockwise(const Vec2& p, const Vec2& q, const Vec2& r) {
    const Vec2 d = q - p;
    const Vec2 e = r - p;
    return detail::cross(d, e) > kOrientationError * detail::cross_bound(d, e);
}

/// The element beyond a side of the untriangulated part of the strip.
struct Beyond {
    enum { kHalfedge, kChainEdge, kFirstEdge } what;
    /// The halfedge, or the lower site of the edge of a chain.
    int id;
};

class StripBuilder {
   public:
    StripBuilder(const Points& coordinates, const SpatialSort& columns)
        : coordinates_(coordinates),
          columns_(columns),
          chain_halfedge_(columns.order.size(), -1),
          opposite_(6 * columns.order.size(), -1) {
        corner_sites_.reserve(6 * columns.order.size());
        corner_offsets_.reserve(2 * columns.order.size());
    }

    bool build() {
        for (int k = 0; k < columns_.n_columns(); ++k) {
            checkpoint();
            merge_chains(k);
            if (!triangulate_strip()) return false;
        }
        return true;
    }

    TorusTriangulation take() {
        return {static_cast<int>(columns_.order.size()), std::move(corner_sites_),
                std::move(corner_offsets_), std::move(opposite_)};
    }

   private:
    std::span<const SiteId> column(int k) const {
        return std::span(columns_.order)
            .subspan(columns_.begin[k], columns_.begin[k + 1] - columns_.begin[k]);
    }

    /// Vertex k of the chain through `column`; k continues round the torus.
    StripVertex chain_vertex(std::span<const SiteId> column, std::size_t k, int i,
                             bool on_right) const {
        const int round = k < column.size() ? 0 : 1;
        const SiteId site = column[k - round * column.size()];
        const Vec2 shift(i, round);
        if (columns_.across == 0) {
            return {site, {i, round}, coordinates_.col(site) + shift, on_right};
        }
        return {site, {round, i}, coordinates_.col(site).reverse() + shift, on_right};
    }

    /// Merges the vertices of both chains upwards: from two consecutive vertices on different
    /// chains to the images of the same two.
    void merge_chains(int k) {
        const auto left = column(k);
        const bool last = k + 1 == columns_.n_columns();
        const auto right = column(last ? 0 : k + 1);
        const auto at_left = [&](std::size_t m) { return chain_vertex(left, m, 0, false); };
        const auto at_right = [&](std::size_t m) { return chain_vertex(right, m, last, true); };

        // Find the two lowest vertices between which a cut edge can run.
        std::size_t l = 0;
        std::size_t r = 0;
        if (below(at_left(0).point, at_right(0).point)) {
            while (l + 1 < left.size() && below(at_left(l + 1).point, at_right(0).point)) ++l;
        } else {
            while (r + 1 < right.size() && below(at_right(r + 1).point, at_left(0).point)) ++r;
        }
        // Merge both chains upwards, once round the torus.
        vertices_.clear();
        const std::size_t l_end = l + left.size();
        const std::size_t r_end = r + right.size();
        StripVertex next_left = at_left(l);
        StripVertex next_right = at_right(r);
        while (l <= l_end || r <= r_end) {
            if (r > r_end || (l <= l_end && below(next_left.point, next_right.point))) {
                vertices_.push_back(next_left);
                if (++l <= l_end) next_left = at_left(l);
            } else {
                vertices_.push_back(next_right);
                if (++r <= r_end) next_right = at_right(r);
            }
        }
    }

    bool triangulate_strip() {
        stack_ = {0, 1};
        beyond_ = {{Beyond::kFirstEdge, 0}};
        const int n = static_cast<int>(vertices_.size());
        for (int w = 2; w < n; ++w) {
            const bool across = vertices_[w].on_right != vertices_[stack_.back()].on_right;
            if (!across) {
                join_convex(w);
            } else if (!join_all(w)) {
                return false;
            }
        }
        link(beyond_.front().id, first_halfedge_);
        return true;
    }

    /// Vertex w follows the lowest vertex of the stack on the same chain and sees the whole stack.
    bool join_all(int w) {
        Beyond beside{Beyond::kChainEdge, vertices_[stack_.front()].site};
        for (std::size_t k = 0; k + 1 < stack_.size(); ++k) {
            if (!sees(stack_[k], stack_[k + 1], w)) return false;
            const int t = add_triangle(stack_[k], stack_[k + 1], w);
            attach(side_ab(t), beyond_[k]);
            attach(side_wa(t), beside);
            beside = {Beyond::kHalfedge, side_bw(t)};
        }
        stack_ = {stack_.back(), w};
        beyond_ = {beside};
        return true;
    }

    /// Vertex w follows the highest vertex of the stack on the same chain; it sees the stack down
    /// to the first reflex corner.
    void join_convex(int w) {
        Beyond beside{Beyond::kChainEdge, vertices_[stack_.back()].site};
        while (stack_.size() >= 2 && sees(stack_[stack_.size() - 2], stack_.back(), w)) {
            const int t = add_triangle(stack_[stack_.size() - 2], stack_.back(), w);
            attach(side_ab(t), beyond_.back());
            attach(side_bw(t), beside);
            beside = {Beyond::kHalfedge, side_wa(t)};
            stack_.pop_back();
            beyond_.pop_back();
        }
        stack_.push_back(w);
        beyond_.push_back(beside);
    }

    /// Whether a, b, w (b above a on the stack) form a triangle inside the strip.
    bool sees(int a, int b, int w) {
        const bool right = vertices_[b].on_right;
        const Vec2& p = vertices_[a].point;
        const Vec2& q = vertices_[b].point;
        const Vec2& r = vertices_[w].point;
        // Points with exchanged coordinates are mirrored.
        right_ = right == (columns_.across == 0);
        return right ? surely_counter_clockwise(p, q, r) : surely_counter_clockwise(p, r, q);
    }

    /// Adds the triangle of the last call of sees(): a, b, w on the right, a, w, b on the left, or
    /// in mirrored points the other way round.
    int add_triangle(int a, int b, int w) {
        const StripVertex& first = vertices_[a];
        const StripVertex& second = vertices_[right_ ? b : w];
        const StripVertex& third = vertices_[right_ ? w : b];
        corner_sites_.insert(corner_sites_.end(), {first.site, second.site, third.site});
        corner_offsets_.push_back(
            packed_offsets(second.offset - first.offset, third.offset - first.offset));
        return static_cast<int>(corner_offsets_.size()) - 1;
    }
    int side_ab(int t) const { return right_ ? 3 * t : 3 * t + 2; }
    static int side_bw(int t) { return 3 * t + 1; }
    int side_wa(int t) const { return right_ ? 3 * t + 2 : 3 * t; }

    void link(int h, int o) {
        opposite_[h] = o;
        opposite_[o] = h;
    }

    void attach(int h, const Beyond& beyond) {
        if (beyond.what == Beyond::kHalfedge) {
            link(h, beyond.id);
        } else if (beyond.what == Beyond::kFirstEdge) {
            first_halfedge_ = h;
        } else if (chain_halfedge_[beyond.id] < 0) {
            chain_halfedge_[beyond.id] = h;
        } else {
            link(h, chain_halfedge_[beyond.id]);
        }
    }

    const Points& coordinates_;
    const SpatialSort& columns_;
    /// For the chain edge above each site, the first of its two halfedges.
    std::vector<int> chain_halfedge_;
    std::vector<int> opposite_;
    std::vector<SiteId> corner_sites_;
    std::vector<CornerOffsets> corner_offsets_;

    std::vector<StripVertex> vertices_;
    /// The vertices that are not triangulated yet, upwards; the lowest lies on one chain, all
    /// others on the other chain. beyond_[k] lies beyond the side between the vertices k and k + 1.
    std::vector<int> stack_;
    std::vector<Beyond> beyond_;
    int first_halfedge_ = -1;
    bool right_ = false;
};

bool chains_touch(const Points& coordinates, const SpatialSort& columns) {
    double reached = -1;
    for (int k = 0; k < columns.n_columns(); ++k) {
        checkpoint();
        double lowest = 1;
        double highest = 0;
        for (int m = columns.begin[k]; m < columns.begin[k + 1]; ++m) {
            const double across = coordinates(columns.across, columns.order[m]);
            lowest = std::min(lowest, across);
            highest = std::max(highest, across);
        }
        if (lowest <= reached) return true;
        reached = highest;
    }
    return false;
}

}  // namespace

std::optional<TorusTriangulation> strip_triangulation(const Points& coordinates,
                                                      const SpatialSort& columns) {
    if (chains_touch(coordinates, columns)) return std::nullopt;
    StripBuilder builder(coordinates, columns);
    if (!builder.build()) return std::nullopt;
    return builder.take();
}

}  // namespace pcvt::plane
