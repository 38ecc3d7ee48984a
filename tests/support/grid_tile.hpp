#pragma once

#include "mesher/tile/tile.hpp"

namespace pcvt::testing {

/// A tile of columns x rows congruent parallelograms, site ids row by row: a tile that can be
/// written down without any of the code under test.
Tile grid_tile(const Lattice& lattice, int columns, int rows);

/// The same with each parallelogram cut into two triangles; sites are the grid points.
Tile triangle_grid_tile(const Lattice& lattice, int columns, int rows);

/// The same two triangles a parallelogram, which is their grain.
Tile grain_grid_tile(const Lattice& lattice, int columns, int rows);

}  // namespace pcvt::testing
