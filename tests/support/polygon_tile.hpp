#pragma once

#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt::testing {

/// A tile whose faces are the polygons; corners closer than 1e-9 share a vertex. Has no stored
/// pairs.
plane::Tile polygon_tile(const plane::Lattice& lattice,
                         const std::vector<plane::Polygon>& polygons);

/// columns x rows regular hexagons with edges of length 1, on the lattice that they fill: a
/// centroidal Voronoi tessellation.
plane::Tile honeycomb_tile(int columns, int rows);

/// Unit squares whose sides bulge by different amounts, so that two sides match only where they are
/// meant to be glued. Their lattice need not be the unit square lattice.
struct SquareTiled {
    /// Lower left corners, integers.
    std::vector<plane::Vec2> at;
    /// The right side of square s is glued to the left side of square right[s].
    std::vector<int> right;
    /// The upper side of square s is glued to the lower side of square above[s].
    std::vector<int> above;
};

/// Converts such a surface to a tile of the unit square lattice.
plane::Tile square_tiled(const SquareTiled& surface);

/// Converts each face of `tile` to a fan of triangles on vertices of its own, rounded to float32.
/// Stored vertex pairs name the first copy; sites are kept.
plane::Tile float_fans(const plane::Tile& tile);

}  // namespace pcvt::testing
