#include "mesher/plane/delaunay/lawson_flips.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/prefetch.hpp"

namespace pcvt::plane {
namespace {

/// Returns a positive value if the apex beyond h certainly lies inside the circle of h's triangle,
/// a negative value if it certainly lies outside, else 0. Differences of coordinates without
/// offsets are exact.
double filter(const TorusTriangulation& triangulation, const Points& coordinates, const Gram& gram,
              int h) {
    const int o = triangulation.opposite(h);
    if (triangulation.has_offsets(h) || triangulation.has_offsets(o)) return 0;
    ++detail::predicate_counts.calls;
    const auto at = [&](int g) -> Vec2 { return coordinates.col(triangulation.corner_sites()[g]); };
    const Vec2 p = at(h);
    const Vec2 q = at(TorusTriangulation::next(h));
    const Vec2 r = at(TorusTriangulation::previous(h));
    const Vec2 s = at(TorusTriangulation::previous(o));
    return detail::in_circle_filter(gram, p - r, q - r, p - s, q - s);
}

/// Prefetches the data that the flips of a list of suspects will touch. It works in steps, each of
/// which reads only data that an earlier step has prefetched. Where the triangulation exceeds the
/// cache, a flip otherwise waits for a dozen cache lines in sequence, twice as long as it computes.
class Fetcher {
   public:
    Fetcher(const TorusTriangulation& triangulation, const Points& coordinates,
            const std::vector<int>& suspects, const FlipObserver* observer)
        : triangulation_(triangulation),
          coordinates_(coordinates),
          suspects_(suspects),
          observer_(observer) {}

    /// Must be called for k = 0, 1, ..., each time before suspect k is examined.
    void fetch_for(std::size_t k) const {
        const auto at_step = [&](std::size_t step, const auto& fetch) {
            if (k + step * kApart < suspects_.size()) fetch(suspects_[k + step * kApart]);
        };
        at_step(4, [&](int h) { triangulation_.fetch_triangle(h); });
        at_step(3, [&](int h) { fetch_triangles(h); });
        at_step(2, [&](int h) { fetch_sides(h); });
        at_step(1, [&](int h) { fetch_beyond_sides(h); });
    }

   private:
    /// The number of suspects between two steps.
    static constexpr std::size_t kApart = 8;

    /// The halfedges of the quadrilateral's four sides.
    std::array<int, 4> sides(int h) const {
        const int o = triangulation_.opposite(h);
        return {TorusTriangulation::next(h), TorusTriangulation::previous(h),
                TorusTriangulation::next(o), TorusTriangulation::previous(o)};
    }
    void fetch_origin(int h) const {
        const SiteId site = triangulation_.corner_sites()[h];
        prefetch(coordinates_.data() + 2 * std::size_t(site));
        if (observer_ != nullptr) observer_->fetch(site);
    }
    void fetch_triangles(int h) const {
        triangulation_.fetch_triangle(triangulation_.opposite(h));
        fetch_origin(h);
        fetch_origin(TorusTriangulation::next(h));
        fetch_origin(TorusTriangulation::previous(h));
    }
    void fetch_sides(int h) const {
        fetch_origin(TorusTriangulation::previous(triangulation_.opposite(h)));
        for (const int side : sides(h))
            triangulation_.fetch_triangle(triangulation_.opposite(side));
    }
    void fetch_beyond_sides(int h) const {
        for (const int side : sides(h)) {
            const int apex = TorusTriangulation::previous(triangulation_.opposite(side));
            const SiteId site = triangulation_.corner_sites()[apex];
            prefetch(coordinates_.data() + 2 * std::size_t(site));
        }
    }

    const TorusTriangulation& triangulation_;
    const Points& coordinates_;
    const std::vector<int>& suspects_;
    const FlipObserver* observer_;
};

}  // namespace

bool is_certainly_delaunay(const TorusTriangulation& triangulation, const Points& coordinates,
                           const Gram& gram, int h) {
    return filter(triangulation, coordinates, gram, h) < 0;
}

bool LawsonFlips::is_counter_clockwise(int triangle) const {
    const int h = 3 * triangle;
    return orientation(corner_image(h), corner_image(h + 1), corner_image(h + 2)) > 0;
}

bool LawsonFlips::is_locally_delaunay(int h) const {
    if (triangulation_.opposite(h) == h) return true;
    const double sign = filter(triangulation_, coordinates_, gram_, h);
    if (sign != 0) return sign < 0;
    const Corner apex = triangulation_.apex_across(h);
    return in_circle(gram_, corner_image(h), corner_image(TorusTriangulation::next(h)),
                     corner_image(TorusTriangulation::previous(h)),
                     image(coordinates_, apex.site, apex.offset)) <= 0;
}

/// Flips the edge of `first`, if it is not locally Delaunay, and then the edges that become
/// suspects, except edges whose halfedges both come after `last`; leaves the stack empty.
std::int64_t LawsonFlips::flip_from(int first, int last, std::vector<int>& stack,
                                    FlipObserver* observer) {
    std::int64_t n_flips = 0;
    stack.push_back(first);
    while (!stack.empty()) {
        const int h = stack.back();
        stack.pop_back();
        if (is_locally_delaunay(h)) continue;
        if (observer != nullptr) observer->before_flip(h);
        const int o = triangulation_.opposite(h);
        triangulation_.flip(h);
        ++n_flips;
        if (observer != nullptr) observer->after_flip(h);
        for (const int side : {TorusTriangulation::next(h), TorusTriangulation::previous(h),
                               TorusTriangulation::next(o), TorusTriangulation::previous(o)}) {
            if (std::min(side, triangulation_.opposite(side)) <= last) stack.push_back(side);
        }
    }
    return n_flips;
}

std::int64_t LawsonFlips::flip(std::vector<int>& suspects, FlipObserver* observer) {
    std::int64_t n_flips = 0;
    std::vector<int> stack;
    const Fetcher fetcher(triangulation_, coordinates_, suspects, observer);
    for (std::size_t k = 0; k < suspects.size(); ++k) {
        checkpoint_each(k);
        fetcher.fetch_for(k);
        n_flips += flip_from(suspects[k], triangulation_.n_halfedges(), stack, observer);
    }
    suspects.clear();
    return n_flips;
}

std::int64_t LawsonFlips::flip_all() {
    return flip_edges(std::numeric_limits<std::int64_t>::max());
}

bool LawsonFlips::flip_all_within(std::int64_t most) { return flip_edges(most) <= most; }

/// Flips until all edges are Delaunay or there were more than `most` flips; returns their number.
std::int64_t LawsonFlips::flip_edges(std::int64_t most) {
    std::int64_t n_flips = 0;
    std::vector<int> stack;
    for (int h = 0; h < triangulation_.n_halfedges() && n_flips <= most; ++h) {
        checkpoint_each(h);
        if (h < triangulation_.opposite(h)) n_flips += flip_from(h, h, stack, nullptr);
    }
    return n_flips;
}

}  // namespace pcvt::plane
