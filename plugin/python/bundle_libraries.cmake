# Copies the shared libraries that LIBRARY needs, and that a plain Debian or Ubuntu lacks, into its folder; their
# licences into FOLDER/licences, as far as Debian's package manager knows them. Strips all of them.
#   cmake -DLIBRARY=... -DFOLDER=... -DSTRIP=... -P bundle_libraries.cmake
cmake_minimum_required(VERSION 3.25)
get_filename_component(beside ${LIBRARY} DIRECTORY)

# glibc, the C++ run time and zlib are everywhere.
file(GET_RUNTIME_DEPENDENCIES LIBRARIES ${LIBRARY}
  RESOLVED_DEPENDENCIES_VAR libraries
  PRE_EXCLUDE_REGEXES "^lib(c|m|stdc\\+\\+|gcc_s|z)[.]so" "^ld-linux")
file(MAKE_DIRECTORY ${FOLDER}/licences)
foreach(library ${libraries})
  get_filename_component(name ${library} NAME)
  file(REAL_PATH ${library} real)
  file(COPY_FILE ${real} ${beside}/${name})
  execute_process(COMMAND dpkg-query --search "*/${name}" OUTPUT_VARIABLE owner ERROR_QUIET)
  if(owner MATCHES "^([a-z0-9.+-]+)")
    set(package ${CMAKE_MATCH_1})
    file(COPY_FILE /usr/share/doc/${package}/copyright ${FOLDER}/licences/${package}.txt)
  endif()
endforeach()
file(GLOB copies ${beside}/*.so*)
execute_process(COMMAND ${STRIP} --strip-unneeded ${copies} COMMAND_ERROR_IS_FATAL ANY)
