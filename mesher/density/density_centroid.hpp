#pragma once

#include "mesher/density/cell_quadrature.hpp"
#include "mesher/lattice/polygon.hpp"

namespace pcvt {

/// The density-weighted centroid of a convex polygon, length units, by rules of rising order until
/// two agree to 1e-10 of its size, or the highest is reached.
/// @throws BadDensity as the probe does.
Vec2 density_centroid(const Lattice& lattice, const CellQuadrature& quadrature,
                      const Polygon& polygon, DensityProbe& probe);

}  // namespace pcvt
