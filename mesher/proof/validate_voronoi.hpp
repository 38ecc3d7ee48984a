#pragma once

#include <functional>

#include "mesher/lattice/polygon.hpp"
#include "mesher/proof/validate.hpp"

namespace pcvt {

using CentroidFunction = std::function<Vec2(const Polygon&)>;

/// The same as prove_voronoi of cells for any kind of centroid: that of a density, for instance.
/// Triangles have none.
double prove_voronoi(const Tile& tile, const TileProof& proof, double tolerance,
                     const CentroidFunction& centroid);

}  // namespace pcvt
