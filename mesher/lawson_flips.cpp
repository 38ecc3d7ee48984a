#include "mesher/lawson_flips.hpp"

namespace pcvt {
namespace {

/// Positive if the apex beyond h lies certainly inside the circle of h's triangle, negative if
/// certainly outside. Differences of coordinates without offsets are exact.
double filter(const TorusTriangulation& triangulation, const Points& coordinates, const Gram& gram,
              int h) {
    const int o = triangulation.opposite(h);
    if (triangulation.has_offsets(h) || triangulation.has_offsets(o)) return 0;
    ++detail::predicate_counts.asked;
    const auto at = [&](int g) -> Vec2 { return coordinates.col(triangulation.corner_sites()[g]); };
    const Vec2 p = at(h);
    const Vec2 q = at(TorusTriangulation::next(h));
    const Vec2 r = at(TorusTriangulation::previous(h));
    const Vec2 s = at(TorusTriangulation::previous(o));
    return detail::in_circle_filter(gram, p - r, q - r, p - s, q - s);
}

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
    const double sign = filter(triangulation_, coordinates_, gram_, h);
    if (sign != 0) return sign < 0;
    const Corner apex = triangulation_.apex_across(h);
    return in_circle(gram_, corner_image(h), corner_image(TorusTriangulation::next(h)),
                     corner_image(TorusTriangulation::previous(h)),
                     image(coordinates_, apex.site, apex.offset)) <= 0;
}

std::int64_t LawsonFlips::flip(std::vector<int>& suspects, FlipObserver* observer) {
    std::int64_t n_flips = 0;
    while (!suspects.empty()) {
        const int h = suspects.back();
        suspects.pop_back();
        if (is_locally_delaunay(h)) continue;
        if (observer != nullptr) observer->before_flip(h);
        const int o = triangulation_.opposite(h);
        triangulation_.flip(h);
        ++n_flips;
        if (observer != nullptr) observer->after_flip(h);
        for (const int side : {h, o}) {
            suspects.push_back(TorusTriangulation::next(side));
            suspects.push_back(TorusTriangulation::previous(side));
        }
    }
    return n_flips;
}

std::int64_t LawsonFlips::flip_all() {
    std::int64_t n_flips = 0;
    std::vector<int> suspects;
    for (int h = 0; h < triangulation_.n_halfedges(); ++h) {
        if (h < triangulation_.opposite(h)) {
            suspects.push_back(h);
            n_flips += flip(suspects);
        }
    }
    return n_flips;
}

}  // namespace pcvt
