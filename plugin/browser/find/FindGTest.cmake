# GoogleTest from Debian's package of its sources.
set(folder /usr/src/googletest)
foreach(part googletest googlemock)
  list(APPEND includes ${folder}/${part}/include ${folder}/${part})
endforeach()
add_library(gmock_main STATIC
  ${folder}/googletest/src/gtest-all.cc ${folder}/googlemock/src/gmock-all.cc ${folder}/googlemock/src/gmock_main.cc)
target_include_directories(gmock_main SYSTEM PUBLIC ${includes})
target_compile_options(gmock_main PRIVATE -w)
target_compile_features(gmock_main PUBLIC cxx_std_20)
add_library(GTest::gmock_main ALIAS gmock_main)
set(GTest_FOUND TRUE)
