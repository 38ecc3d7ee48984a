#pragma once

#include "mesher/plane/cvt/area_cvt.hpp"
#include "mesher/plane/tile/build_tile.hpp"

namespace pcvt::testing {

/// How the cells of a test tile differ from Voronoi cells.
struct CellShape {
    const char* name;
    /// A law of areas; empty: Voronoi cells.
    const char* law;
    plane::Metric metric = {};
};

/// Power cells, elongated cells, and elongated power cells.
std::vector<CellShape> cell_shapes();

/// Cells of n random sites, after some centroidal steps (negative: until they are centroidal).
plane::AreaCvtResult power_cells(const plane::Lattice& lattice, int n, int seed,
                                 const CellShape& shape, int centroidal_steps = 0);

/// The tile of such cells. The file of the tile, read back, has its positions.
plane::Tile power_tile(const plane::Lattice& lattice, int n, int seed, const CellShape& shape,
                       plane::TileOptions options = {}, int centroidal_steps = 0);

/// All kinds and outlines, once and repeated, and grains of order 2.
std::vector<plane::TileOptions> tile_kinds();

}  // namespace pcvt::testing
