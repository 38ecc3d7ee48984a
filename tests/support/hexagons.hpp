#pragma once

#include "mesher/plane/mesh/periodic_mesh.hpp"

namespace pcvt::testing {

/// Regular hexagons of unit spacing, `columns` in each of `rows` rows, on a rectangular torus.
/// @pre rows is even.
plane::PeriodicMesh hexagonal_cells(int columns, int rows);

}  // namespace pcvt::testing
