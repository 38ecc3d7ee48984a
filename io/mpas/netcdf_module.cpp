#include "io/mpas/netcdf_module.hpp"

#include <dlfcn.h>

#include "io/mpas/netcdf_functions.hpp"

namespace pcvt {
namespace {

NetcdfModule load() {
    void* library = dlopen("pcvt_mpas.so", RTLD_NOW | RTLD_LOCAL);
    const void* table = library == nullptr ? nullptr : dlsym(library, "kNetcdfFunctions");
    if (table != nullptr) return {static_cast<const NetcdfFunctions*>(table), ""};
    const char* reason = dlerror();
    return {nullptr, "reading and writing .nc needs netCDF (" + std::string(reason) +
                         "); install libnetcdf19 and pcvt's own module lib/pcvt/pcvt_mpas.so"};
}

}  // namespace

const NetcdfModule& netcdf_module() {
    static const NetcdfModule loaded = load();
    return loaded;
}

}  // namespace pcvt
