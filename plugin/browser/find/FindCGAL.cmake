# CGAL's headers without GMP and MPFR: pcvt computes exactly with CGAL::MP_Float, which needs neither.
pcvt_link_headers(CGAL boost)
add_library(CGAL::CGAL INTERFACE IMPORTED)
target_include_directories(CGAL::CGAL SYSTEM INTERFACE ${PCVT_SYSTEM_HEADERS})
target_compile_definitions(CGAL::CGAL INTERFACE
  CGAL_DISABLE_GMP CGAL_DISABLE_MPFR CGAL_DO_NOT_USE_BOOST_MP NDEBUG)
set(CGAL_FOUND TRUE)
