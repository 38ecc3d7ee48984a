#pragma once

#include <mutex>

namespace pcvt {

/// The mutex to hold while OpenMesh writes and while netCDF reads or writes: both libraries keep
/// state for the whole process, and several threads write files at the same time.
///
/// Example usage:
///     const std::lock_guard lock(openmesh_netcdf_mutex());
///     OpenMesh::IO::write_mesh(mesh, stream, ".om");
inline std::mutex& openmesh_netcdf_mutex() {
    static std::mutex mutex;
    return mutex;
}

}  // namespace pcvt
