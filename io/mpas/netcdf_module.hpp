#pragma once

#include <string>

namespace pcvt {

struct NetcdfFunctions;

/// netCDF as the module pcvt_mpas.so provides it.
struct NetcdfModule {
    /// nullptr if the module or netCDF cannot be loaded.
    const NetcdfFunctions* functions = nullptr;
    /// The reason and the remedy; empty if both are loaded.
    std::string problem;
};

/// Returns the module, which the first call loads and nothing unloads. netCDF depends on some forty
/// libraries, and programs that neither read nor write `.nc` should not load them. The dynamic
/// linker searches the run path of the object that contains this function: `pcvt/` beside
/// libpcvt.so or the folder itself, `../lib/pcvt` of the command, the build folder, `lib/pcvt` of
/// the package that a program links statically. Any thread, any time.
///
/// Example usage:
///     const NetcdfModule& netcdf = netcdf_module();
///     if (netcdf.functions == nullptr) throw BadFile(path + ": " + netcdf.problem);
const NetcdfModule& netcdf_module();

}  // namespace pcvt
