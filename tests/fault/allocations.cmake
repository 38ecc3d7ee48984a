# Allocations that fail. The shim replaces the allocator, which the sanitizers do as well.
if(NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  add_library(allocation_shim SHARED allocation_shim.c)
  target_include_directories(allocation_shim PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_options(allocation_shim PRIVATE -Wall -Wextra -Werror -fno-builtin)
  add_executable(allocation_host allocation_host.c)
  target_compile_options(allocation_host PRIVATE -Wall -Wextra -Werror)
  target_include_directories(allocation_host PRIVATE ${PROJECT_SOURCE_DIR})
  # The shim comes first, so that its functions are the ones that all libraries call.
  target_link_libraries(allocation_host PRIVATE allocation_shim pcvt::plugin)
  add_test(NAME fault_allocations COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_SOURCE_DIR}/allocations
    --pcvt $<TARGET_FILE:pcvt> --shim $<TARGET_FILE:allocation_shim> --host $<TARGET_FILE:allocation_host>)
  set_tests_properties(fault_allocations PROPERTIES TIMEOUT 600)
endif()
