#pragma once

#include <string>

#include "mesher/finite_volume/mpas_grid.hpp"

namespace pcvt {

/// Encodes an MPAS mesh file: netCDF in the 64-bit offset format, specification 1.0. Latitudes,
/// longitudes and z are 0; the ids in indexTo...ID count from 1, as all indices in the file do.
/// Every variable has `units` and a `long_name`: the unit of length is called m.
///
/// Example usage:
///     const MpasGrid grid = mpas_grid(cells, Vec2(0, 0));
///     output.stage("mesh.nc", encode_mpas(grid));
///
/// @param history  the attribute of this name; empty: none.
/// @throws LimitExceeded  if a table is longer than the format can hold.
std::string encode_mpas(const MpasGrid& grid, const std::string& history = "");

}  // namespace pcvt
