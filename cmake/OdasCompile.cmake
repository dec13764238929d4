# SPDX-License-Identifier: MIT
# The flags that every file of the project is compiled with.
add_library(odas_flags INTERFACE)
target_compile_options(odas_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow
  $<$<BOOL:${ODAS_WERROR}>:-Werror>
  # Let the compiler vectorise: no errno, no traps. Not -ffast-math: NaN checks must live.
  -fno-math-errno -fno-trapping-math
  $<$<CXX_COMPILER_ID:GNU>:-fcx-limited-range>
  # Of files that are compiled together: what one file's names hide is another's.
  $<$<BOOL:${CMAKE_UNITY_BUILD}>:-Wno-shadow>
  $<$<AND:$<BOOL:${CMAKE_UNITY_BUILD}>,$<CXX_COMPILER_ID:GNU>>:-Wno-subobject-linkage>
  # g++ 12 sees overlaps in std::string that are not there (its bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
target_include_directories(odas_flags INTERFACE ${PROJECT_SOURCE_DIR}/src)
target_compile_features(odas_flags INTERFACE cxx_std_20)
if(ODAS_CHECK_CONTRACTS)
  target_compile_definitions(odas_flags INTERFACE ODAS_CHECK_CONTRACTS)
endif()
if(ODAS_SANITIZE)
  target_compile_options(odas_flags INTERFACE -fsanitize=${ODAS_SANITIZE} -fno-sanitize-recover=all
    $<$<CXX_COMPILER_ID:Clang>:-fsanitize-ignorelist=${PROJECT_SOURCE_DIR}/scripts/ubsan.ignore>)
  target_link_options(odas_flags INTERFACE -fsanitize=${ODAS_SANITIZE})
endif()

# odas_room(NAME [LIBRARIES ...]): one room of src/odas: an object library of its .cpp files, and, where
# there are x_test.cpp files beside them, the test program NAME_test. WITHOUT: regular expression of files that
# are left out.
function(odas_room name)
  cmake_parse_arguments(ARG "" "WITHOUT" "LIBRARIES;TEST_LIBRARIES" ${ARGN})
  set(dir ${CMAKE_CURRENT_SOURCE_DIR}/${name})
  file(GLOB sources CONFIGURE_DEPENDS ${dir}/*.cpp)
  if(ARG_WITHOUT)
    list(FILTER sources EXCLUDE REGEX "${ARG_WITHOUT}")
  endif()
  set(tests ${sources})
  list(FILTER tests INCLUDE REGEX "_test\\.cpp$")
  list(FILTER sources EXCLUDE REGEX "_(test|bench)\\.cpp$")
  if(sources)
    add_library(odas_${name} OBJECT ${sources})
    set_target_properties(odas_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_link_libraries(odas_${name} PUBLIC odas_flags ${ARG_LIBRARIES})
  else()
    add_library(odas_${name} INTERFACE)
    target_link_libraries(odas_${name} INTERFACE odas_flags ${ARG_LIBRARIES})
  endif()
  if(tests AND ODAS_BUILD_TESTS)
    set_property(GLOBAL APPEND PROPERTY ODAS_ROOMS_WITH_TESTS ${name})
    set_property(GLOBAL PROPERTY ODAS_TESTS_${name} "${tests}")
    set_property(GLOBAL PROPERTY ODAS_TEST_LIBRARIES_${name} "${ARG_TEST_LIBRARIES}")
  endif()
endfunction()

# odas_test_program(NAME FILES...): a program of tests. There are hundreds of them, and what they test is optimized
# for itself: they are compiled with little optimization and a common precompiled header.
function(odas_test_program name)
  add_executable(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE odas_test_support GTest::gtest GTest::gtest_main rapidcheck)
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>
    # At -O1 g++ 12 sees uninitialized members and writes beyond arrays that are not.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread>)
  target_precompile_headers(${name} REUSE_FROM odas_test_header)
endfunction()

# odas_add_tests(PROGRAM LABEL TIMEOUT): tells ctest of the tests of a program.
function(odas_add_tests program label timeout)
  if(ODAS_TESTS_BY_PROGRAM)
    add_test(NAME ${program} COMMAND ${program} --gtest_brief=1)
    set_tests_properties(${program} PROPERTIES LABELS ${label} TIMEOUT 1200)
  else()
    gtest_discover_tests(${program} PROPERTIES LABELS ${label} TIMEOUT ${timeout} DISCOVERY_TIMEOUT 60)
  endif()
endfunction()
