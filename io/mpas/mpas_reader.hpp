#pragma once

#include <string>

#include "mesher/finite_volume/mpas_grid.hpp"

namespace pcvt {

/// The tables of an MPAS mesh file, as they stand: sizes are right, nothing else is believed.
/// @param path  the file's name in messages.
/// @throws BadFile  it is no netCDF file of the classic formats, or lacks a dimension, a variable
/// or
///                  a period, or a variable has another shape.
MpasGrid decode_mpas(const std::string& path, const std::string& bytes);

}  // namespace pcvt
