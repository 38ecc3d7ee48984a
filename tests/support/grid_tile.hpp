#pragma once

#include "mesher/tile/tile.hpp"

namespace pcvt::testing {

/// A tile of columns x rows congruent parallelograms with site ids row by row, constructed without
/// any of the code under test.
Tile grid_tile(const Lattice& lattice, int columns, int rows);

/// The same grid with each parallelogram cut into two triangles; sites are the grid points.
Tile triangle_grid_tile(const Lattice& lattice, int columns, int rows);

/// The same triangles, where the two triangles of a parallelogram are its grain.
Tile grain_grid_tile(const Lattice& lattice, int columns, int rows);

}  // namespace pcvt::testing
