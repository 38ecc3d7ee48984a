#pragma once

#include <Eigen/Core>
#include <vector>

#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/geometry/sites.hpp"

namespace pcvt::testing {

/// The power cell of each site around the site, length units, by the half-planes of 7 x 7 images of
/// every site; empty for a hidden site.
///
/// @param weights  length^2.
std::vector<plane::Polygon> clipped_power_cells(const plane::Sites& sites,
                                                const Eigen::VectorXd& weights);

/// Integrals over a polygon around the origin: 1, p and |p|^2.
struct PolygonMoments {
    double area = 0;
    plane::Vec2 first = plane::Vec2::Zero();
    double second = 0;
};
PolygonMoments polygon_moments(const plane::Polygon& polygon);

}  // namespace pcvt::testing
