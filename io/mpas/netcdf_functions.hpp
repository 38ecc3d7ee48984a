#pragma once

#include <netcdf.h>
#include <netcdf_mem.h>

namespace pcvt {

/// The functions of netCDF that the reader and the writer call: `open_mem` is nc_open_mem.
struct NetcdfFunctions {
    decltype(&nc_strerror) strerror;
    decltype(&nc_open_mem) open_mem;
    decltype(&nc_close) close;
    decltype(&nc_inq_dimid) inq_dimid;
    decltype(&nc_inq_dimlen) inq_dimlen;
    decltype(&nc_inq_attlen) inq_attlen;
    decltype(&nc_get_att_double) get_att_double;
    decltype(&nc_inq_varid) inq_varid;
    decltype(&nc_inq_varndims) inq_varndims;
    decltype(&nc_inq_vardimid) inq_vardimid;
    decltype(&nc_inq_var) inq_var;
    decltype(&nc_get_var_int) get_var_int;
    decltype(&nc_get_var_double) get_var_double;
    decltype(&nc_create_mem) create_mem;
    decltype(&nc_set_fill) set_fill;
    decltype(&nc_def_dim) def_dim;
    decltype(&nc_put_att_text) put_att_text;
    decltype(&nc_put_att_double) put_att_double;
    decltype(&nc_def_var) def_var;
    decltype(&nc_enddef) enddef;
    decltype(&nc_put_var_int) put_var_int;
    decltype(&nc_put_var_double) put_var_double;
    decltype(&nc_close_memio) close_memio;
    decltype(&nc_abort) abort;
};

}  // namespace pcvt
