// The module pcvt_mpas.so, the one object of pcvt that links netCDF. It shares no C++ type with the
// program that loads it but the table of C functions.

#include "io/mpas/netcdf_functions.hpp"

extern "C" [[gnu::visibility("default")]] const pcvt::NetcdfFunctions kNetcdfFunctions;

const pcvt::NetcdfFunctions kNetcdfFunctions{.strerror = nc_strerror,
                                             .open_mem = nc_open_mem,
                                             .close = nc_close,
                                             .inq_dimid = nc_inq_dimid,
                                             .inq_dimlen = nc_inq_dimlen,
                                             .inq_attlen = nc_inq_attlen,
                                             .get_att_double = nc_get_att_double,
                                             .inq_varid = nc_inq_varid,
                                             .inq_varndims = nc_inq_varndims,
                                             .inq_vardimid = nc_inq_vardimid,
                                             .inq_var = nc_inq_var,
                                             .get_var_int = nc_get_var_int,
                                             .get_var_double = nc_get_var_double,
                                             .create_mem = nc_create_mem,
                                             .set_fill = nc_set_fill,
                                             .def_dim = nc_def_dim,
                                             .put_att_text = nc_put_att_text,
                                             .put_att_double = nc_put_att_double,
                                             .def_var = nc_def_var,
                                             .enddef = nc_enddef,
                                             .put_var_int = nc_put_var_int,
                                             .put_var_double = nc_put_var_double,
                                             .close_memio = nc_close_memio,
                                             .abort = nc_abort};
