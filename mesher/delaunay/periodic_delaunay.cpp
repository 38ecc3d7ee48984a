#include "mesher/delaunay/periodic_delaunay.hpp"

#include <string>

#include "mesher/base/error.hpp"
#include "mesher/delaunay/moving_delaunay.hpp"

namespace pcvt {
namespace {

PeriodicDelaunay built(const Sites& sites) {
    auto [own_sites, triangulation] = MovingDelaunay(sites).release();
    return {std::move(own_sites), std::move(triangulation)};
}

}  // namespace

PeriodicDelaunay::PeriodicDelaunay(const Sites& sites) : PeriodicDelaunay(built(sites)) {}

PeriodicDelaunay::PeriodicDelaunay(Sites sites, TorusTriangulation triangulation)
    : sites_(std::move(sites)),
      triangulation_(std::move(triangulation)),
      gram_(gram_of(sites_.reduction().reduced)) {
    certify();
}

void PeriodicDelaunay::certify() {
    const LawsonFlips look(triangulation_, sites_.coordinates(), gram_);
    for (int t = 0; t < triangulation_.n_triangles(); ++t) {
        if (!look.is_counter_clockwise(t)) {
            throw InternalError("triangle " + std::to_string(t) + " is not counter-clockwise");
        }
    }
    for (int h = 0; h < triangulation_.n_halfedges(); ++h) {
        if (h < triangulation_.opposite(h) && !look.is_locally_delaunay(h)) {
            throw InternalError("edge " + std::to_string(h) + " is not locally Delaunay");
        }
    }
}

}  // namespace pcvt
