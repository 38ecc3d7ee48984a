#pragma once

#include "mesher/lattice/polygon.hpp"
#include "mesher/tile/tile.hpp"

namespace pcvt::testing {

/// A tile whose faces are the polygons; corners closer than 1e-9 share a vertex. Has no stored
/// pairs.
Tile polygon_tile(const Lattice& lattice, const std::vector<Polygon>& polygons);

/// columns x rows regular hexagons with edges of length 1, on the lattice that they fill: a
/// centroidal Voronoi tessellation.
Tile honeycomb_tile(int columns, int rows);

/// Unit squares whose sides bulge by different amounts, so that two sides match only where they are
/// meant to be glued. Their lattice need not be the unit square lattice.
struct SquareTiled {
    /// Lower left corners, integers.
    std::vector<Vec2> at;
    /// The right side of square s is glued to the left side of square right[s].
    std::vector<int> right;
    /// The upper side of square s is glued to the lower side of square above[s].
    std::vector<int> above;
};

/// Converts such a surface to a tile of the unit square lattice.
Tile square_tiled(const SquareTiled& surface);

/// Converts each face of `tile` to a fan of triangles on vertices of its own, rounded to float32.
/// Stored vertex pairs name the first copy; sites are kept.
Tile float_fans(const Tile& tile);

}  // namespace pcvt::testing
