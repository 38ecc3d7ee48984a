#pragma once

#include "mesher/plane/proof/proven_faces.hpp"

namespace pcvt::plane {

/// Works like prove_voronoi (validate.hpp), with any kind of centroid for cells, e.g. of a density.
/// Triangles do not use it.
///
/// Example usage:
///   const double distance = prove_voronoi(tile, proof, 1e-6, polygon_centroid);
double prove_voronoi(const Tile& tile, const TileProof& proof, double tolerance,
                     const CentroidFunction& centroid);

}  // namespace pcvt::plane
