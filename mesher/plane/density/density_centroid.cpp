#include "mesher/plane/density/density_centroid.hpp"

#include <cmath>

#include "mesher/plane/density/quadrature.hpp"

namespace pcvt::plane {
namespace {

constexpr double kAgreement = 1e-10;

}  // namespace

Vec2 density_centroid(const Lattice& lattice, const CellQuadrature& quadrature,
                      const Polygon& polygon, DensityProbe& probe) {
    const Vec2 middle = polygon_centroid(polygon);
    const double size = std::sqrt(polygon_area(polygon));
    CellPolygon cell;
    for (const Vec2& corner : polygon) {
        cell.push_back({corner - middle, lattice.to_lattice(corner)});
    }
    const Vec2 site = lattice.to_lattice(middle);
    Vec2 centroid = Vec2::Constant(INFINITY);
    for (int q = kLeastOrder; q <= kGreatestOrder; ++q) {
        const Moments moments = quadrature(cell, site, q, probe);
        const Vec2 before = centroid;
        centroid = moments.first / moments.mass;
        if ((centroid - before).norm() <= kAgreement * size) break;
    }
    return middle + centroid;
}

}  // namespace pcvt::plane
