#pragma once

#include <string>

#include "mesher/finite_volume/mpas_grid.hpp"

namespace pcvt {

/// An MPAS mesh file: netCDF, 64-bit offset format, specification 1.0. Latitudes, longitudes and z
/// are 0; the ids in indexTo...ID count from 1 like all indices in the file.
/// @throws LimitExceeded  a table is longer than the format can hold.
/// @throws InternalError  netCDF does not write.
std::string encode_mpas(const MpasGrid& grid);

}  // namespace pcvt
