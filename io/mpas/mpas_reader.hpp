#pragma once

#include <string>

#include "mesher/finite_volume/mpas_grid.hpp"

namespace pcvt {

/// Reads the tables of an MPAS mesh file. Their sizes and the ids are checked; prove_mpas_grid()
/// checks everything else.
///
/// Example usage:
///     const MpasGrid grid = decode_mpas("mesh.nc", read_whole_file("mesh.nc"));
///     const MpasGridProof proof = prove_mpas_grid(grid);
///
/// @param path  the file's name in messages.
/// @throws BadFile if the file is not a netCDF file in a classic format, or lacks a dimension, a
///                 variable or a period, or a variable has another shape; also if netCDF cannot be
///                 loaded.
MpasGrid decode_mpas(const std::string& path, const std::string& bytes);

}  // namespace pcvt
