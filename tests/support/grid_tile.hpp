#pragma once

#include "mesher/plane/tile/tile.hpp"

namespace pcvt::testing {

/// A tile of columns x rows congruent parallelograms with site ids row by row, constructed without
/// any of the code under test.
plane::Tile grid_tile(const plane::Lattice& lattice, int columns, int rows);

/// The same grid with each parallelogram cut into two triangles; sites are the grid points.
plane::Tile triangle_grid_tile(const plane::Lattice& lattice, int columns, int rows);

/// The same triangles, where the two triangles of a parallelogram are its grain.
plane::Tile grain_grid_tile(const plane::Lattice& lattice, int columns, int rows);

}  // namespace pcvt::testing
