# System calls that fail, and kills at them. The sanitizers make calls of their own.
if(NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  add_library(system_call_shim SHARED system_call_shim.c)
  target_compile_options(system_call_shim PRIVATE -Wall -Wextra -Werror)
  target_link_libraries(system_call_shim PRIVATE ${CMAKE_DL_LIBS})
  pcvt_c_program(system_call_host system_call_host.c)
  target_link_libraries(system_call_host PRIVATE pcvt::plugin)
  foreach(campaign system_calls kills)
    add_test(NAME fault_${campaign} COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_SOURCE_DIR}/${campaign}
      --pcvt $<TARGET_FILE:pcvt> --shim $<TARGET_FILE:system_call_shim> --host $<TARGET_FILE:system_call_host>)
    set_tests_properties(fault_${campaign} PROPERTIES TIMEOUT 600)
  endforeach()
endif()
