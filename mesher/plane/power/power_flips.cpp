#include "mesher/plane/power/power_flips.hpp"

#include <algorithm>

#include "mesher/base/checkpoint.hpp"

namespace pcvt::plane {

bool PowerFlips::is_locally_regular(int h) const {
    const TorusTriangulation& t = triangulation_;
    return in_power_circle(gram_, weighted_image(t.corner(h)),
                           weighted_image(t.corner(TorusTriangulation::next(h))),
                           weighted_image(t.corner(TorusTriangulation::previous(h))),
                           weighted_image(t.apex_across(h))) <= 0;
}

/// Returns the end of the edge at which its quadrilateral is not strictly convex, if any.
std::optional<SiteId> PowerFlips::hidden_end(int h) const {
    const TorusTriangulation& t = triangulation_;
    const Corner from = t.corner(h);
    const Corner to = t.corner(TorusTriangulation::next(h));
    const auto at = [&](const Corner& c) { return image(coordinates_, c.site, c.offset); };
    const Image apex = at(t.corner(TorusTriangulation::previous(h)));
    const Image across = at(t.apex_across(h));
    if (orientation(across, apex, at(from)) <= 0) return from.site;
    if (orientation(apex, across, at(to)) <= 0) return to.site;
    return std::nullopt;
}

/// Flips the edge of `first`, if it is not locally regular, and then the edges that become
/// suspects, except edges whose halfedges both come after `first`, which follow later.
std::optional<SiteId> PowerFlips::flip_from(int first, std::vector<int>& stack) {
    stack.assign(1, first);
    while (!stack.empty()) {
        const int h = stack.back();
        stack.pop_back();
        if (is_locally_regular(h)) continue;
        if (const auto hidden = hidden_end(h)) return hidden;
        const int o = triangulation_.opposite(h);
        triangulation_.flip(h);
        ++n_flips_;
        for (const int side : {TorusTriangulation::next(h), TorusTriangulation::previous(h),
                               TorusTriangulation::next(o), TorusTriangulation::previous(o)}) {
            if (std::min(side, triangulation_.opposite(side)) <= first) stack.push_back(side);
        }
    }
    return std::nullopt;
}

std::optional<SiteId> PowerFlips::run() {
    std::vector<int> stack;
    for (int h = 0; h < triangulation_.n_halfedges(); ++h) {
        checkpoint_each(h);
        if (h > triangulation_.opposite(h)) continue;
        if (const auto hidden = flip_from(h, stack)) return hidden;
    }
    return std::nullopt;
}

}  // namespace pcvt::plane
