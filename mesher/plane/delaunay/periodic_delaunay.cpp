#include "mesher/plane/delaunay/periodic_delaunay.hpp"

#include <string>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/delaunay/moving_delaunay.hpp"

namespace pcvt::plane {
namespace {

PeriodicDelaunay built(const Sites& sites) {
    auto [own_sites, triangulation] = MovingDelaunay(sites).release();
    return {std::move(own_sites), std::move(triangulation)};
}

}  // namespace

PeriodicDelaunay::PeriodicDelaunay(const Sites& sites) : PeriodicDelaunay(built(sites)) {}

PeriodicDelaunay::PeriodicDelaunay(Sites sites, TorusTriangulation triangulation)
    : PeriodicDelaunay(std::move(sites), std::move(triangulation), {}) {}

PeriodicDelaunay::PeriodicDelaunay(Sites sites, TorusTriangulation triangulation,
                                   Eigen::VectorXd weights)
    : sites_(std::move(sites)),
      triangulation_(std::move(triangulation)),
      gram_(gram_of(sites_.reduction().reduced)),
      weights_(std::move(weights)) {
    const double unit = gram_unit(sites_.reduction().reduced);
    gram_weight_ = 1 / (unit * unit);
    certify();
}

WeightedImage PeriodicDelaunay::weighted_image(const Corner& corner) const {
    const double weight = weights_.size() == 0 ? 0 : gram_weight_ * weights_[corner.site];
    return {image(sites_, corner.site, corner.offset), weight};
}

Vec2 PeriodicDelaunay::dual_vertex(int triangle) const {
    const Corner first = triangulation_.corner(3 * triangle);
    const Vec2 centre = orthocentre(gram_, weighted_image(first),
                                    weighted_image(triangulation_.corner(3 * triangle + 1)),
                                    weighted_image(triangulation_.corner(3 * triangle + 2)));
    const Lattice& reduced = sites_.reduction().reduced;
    return sites_.position(first.site) + reduced.translation(first.offset) +
           reduced.to_position(centre);
}

bool PeriodicDelaunay::is_locally_regular(int h) const {
    const TorusTriangulation& t = triangulation_;
    return in_power_circle(gram_, weighted_image(t.corner(h)),
                           weighted_image(t.corner(TorusTriangulation::next(h))),
                           weighted_image(t.corner(TorusTriangulation::previous(h))),
                           weighted_image(t.apex_across(h))) <= 0;
}

void PeriodicDelaunay::certify() {
    const LawsonFlips look(triangulation_, sites_.coordinates(), gram_);
    for (int t = 0; t < triangulation_.n_triangles(); ++t) {
        checkpoint_each(t);
        if (!look.is_counter_clockwise(t)) {
            throw InternalError("triangle " + std::to_string(t) + " is not counter-clockwise");
        }
    }
    const bool weighted = weights_.size() > 0;
    for (int h = 0; h < triangulation_.n_halfedges(); ++h) {
        checkpoint_each(h);
        if (h > triangulation_.opposite(h)) continue;
        if (weighted ? is_locally_regular(h) : look.is_locally_delaunay(h)) continue;
        throw InternalError("edge " + std::to_string(h) + " is not locally " +
                            (weighted ? "regular" : "Delaunay"));
    }
}

}  // namespace pcvt::plane
