#pragma once

#include "mesher/plane/density/cell_quadrature.hpp"
#include "mesher/plane/geometry/polygon.hpp"

namespace pcvt::plane {

/// The density-weighted centroid of a convex polygon, length units. The order of the rule increases
/// until two successive results agree to 1e-10 of the polygon's size or the highest order is
/// reached.
///
/// Example usage:
///
///     DensityProbe probe(lattice, density.make_function());
///     const Vec2 g = density_centroid(lattice, CellQuadrature(density), polygon, probe);
///
/// @throws BadDensity as the probe does.
Vec2 density_centroid(const Lattice& lattice, const CellQuadrature& quadrature,
                      const Polygon& polygon, DensityProbe& probe);

}  // namespace pcvt::plane
