# Included by the first project(): header-only libraries of Debian are used as they are installed, but the compiler of
# WebAssembly must not see the rest of /usr/include.
enable_language(C)
set(PCVT_SYSTEM_HEADERS ${CMAKE_BINARY_DIR}/system_headers)
function(pcvt_link_headers)
  file(MAKE_DIRECTORY ${PCVT_SYSTEM_HEADERS})
  foreach(name ${ARGN})
    file(CREATE_LINK /usr/include/${name} ${PCVT_SYSTEM_HEADERS}/${name} SYMBOLIC)
  endforeach()
endfunction()
