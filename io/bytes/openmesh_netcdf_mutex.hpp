#pragma once

#include <mutex>

namespace pcvt {

/// To be held while OpenMesh writes and while netCDF reads or writes: both keep state for the whole
/// process, and files are written by several threads at once.
inline std::mutex& openmesh_netcdf_mutex() {
    static std::mutex mutex;
    return mutex;
}

}  // namespace pcvt
