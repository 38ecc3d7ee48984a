#include "mesher/periodic_delaunay.hpp"

#include <string>

#include "mesher/error.hpp"
#include "mesher/mirror_diagram.hpp"

namespace pcvt {

PeriodicDelaunay::PeriodicDelaunay(Sites sites)
    : sites_(std::move(sites)), gram_(gram_of(sites_.reduction().reduced)), triangulation_(0, {}) {
    build();
    certify();
}

void PeriodicDelaunay::build() {
    const MirrorDiagram diagram = mirror_diagram(sites_);
    triangulation_ = TorusTriangulation(sites_.n_sites(), diagram.triangles);
    n_mirrors_ = diagram.n_mirrors;
}

Image PeriodicDelaunay::corner_image(int h) const {
    const Corner& corner = triangulation_.corner(h);
    return image(sites_, corner.site, corner.offset);
}

bool PeriodicDelaunay::all_counter_clockwise() const {
    for (int h = 0; h < triangulation_.n_halfedges(); h += 3) {
        if (orientation(corner_image(h), corner_image(h + 1), corner_image(h + 2)) <= 0) {
            return false;
        }
    }
    return true;
}

bool PeriodicDelaunay::locally_delaunay(int h) const {
    const Corner apex = triangulation_.apex_across(h);
    return in_circle(gram_, corner_image(h), corner_image(TorusTriangulation::next(h)),
                     corner_image(TorusTriangulation::previous(h)),
                     image(sites_, apex.site, apex.offset)) <= 0;
}

void PeriodicDelaunay::flip_until_delaunay() {
    std::vector<int> suspects;
    const auto examine = [&](int h) {
        if (!locally_delaunay(h)) suspects.push_back(h);
    };
    for (int h = 0; h < triangulation_.n_halfedges(); ++h) {
        if (h < triangulation_.opposite(h)) examine(h);
    }
    while (!suspects.empty()) {
        const int h = suspects.back();
        suspects.pop_back();
        if (locally_delaunay(h)) continue;
        const int o = triangulation_.opposite(h);
        triangulation_.flip(h);
        ++n_flips_;
        for (const int side : {h, o}) {
            examine(TorusTriangulation::next(side));
            examine(TorusTriangulation::previous(side));
        }
    }
}

bool PeriodicDelaunay::move_to(const Points& points) {
    std::vector<Offset> change = sites_.wraps();
    if (!sites_.move_to(points)) return false;
    for (std::size_t s = 0; s < change.size(); ++s) change[s] = sites_.wraps()[s] - change[s];
    triangulation_.add_to_offsets(change);
    if (all_counter_clockwise()) {
        flip_until_delaunay();
        return true;
    }
    if (sites_.duplicates().first >= 0) return false;
    build();
    ++n_rebuilds_;
    return true;
}

void PeriodicDelaunay::certify() const {
    if (!all_counter_clockwise())
        throw InternalError("a Delaunay triangle is not counter-clockwise");
    for (int h = 0; h < triangulation_.n_halfedges(); ++h) {
        if (!locally_delaunay(h)) {
            throw InternalError("edge " + std::to_string(h) + " is not locally Delaunay");
        }
    }
}

}  // namespace pcvt
