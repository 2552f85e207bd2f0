# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause

# What all targets of slam_core have in common.
function(slam_core_target target)
  target_compile_features(${target} PUBLIC cxx_std_17)
  # A fused multiply-add rounds otherwise: results would depend on what the compiler contracts.
  target_compile_options(${target} PUBLIC -ffp-contract=off
                         PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wshadow
                         $<$<BOOL:${SLAM_WERROR}>:-Werror>)
  if(SLAM_SANITIZE)
    # Not the checks of each pointer: the address sanitizer sees a null or a short object as well,
    # and together they take a quarter of the time to compile.
    target_compile_options(${target} PUBLIC -fsanitize=address,undefined
                           -fno-sanitize=null,object-size,alignment,vptr
                           -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=address,undefined)
  endif()
  if(SLAM_FUZZ)
    target_compile_options(${target} PUBLIC -fsanitize=fuzzer-no-link)
  endif()
endfunction()

# slam_core_library(NAME SOURCES ... LINK ...): the shared library slam_core_NAME, for other
# packages slam_core::NAME.
function(slam_core_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  set(target slam_core_${name})
  add_library(${target} SHARED ${ARG_SOURCES})
  add_library(slam_core::${name} ALIAS ${target})
  slam_core_target(${target})
  target_link_libraries(${target} PUBLIC ${ARG_LINK})
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/..>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
endfunction()

# slam_core_program(NAME LINK ...): the program slam_core_NAME of tools/NAME.cpp.
function(slam_core_program name)
  cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
  add_executable(slam_core_${name} tools/${name}.cpp)
  slam_core_target(slam_core_${name})
  target_link_libraries(slam_core_${name} PRIVATE ${ARG_LINK})
endfunction()

# slam_core_install(LIBRARIES name... PROGRAMS target...): libraries, headers, programs, and the
# targets for other packages, from the build tree as from the installation.
function(slam_core_install)
  cmake_parse_arguments(ARG "" "" "LIBRARIES;PROGRAMS" ${ARGN})
  list(TRANSFORM ARG_LIBRARIES PREPEND slam_core_ OUTPUT_VARIABLE targets)
  install(TARGETS ${targets} EXPORT slam_core_targets
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  foreach(name IN LISTS ARG_LIBRARIES)
    # those of the tests as well: other packages' back-ends pass the contract suite, too
    install(DIRECTORY ${name} DESTINATION include/slam_core FILES_MATCHING PATTERN "*.hpp")
  endforeach()
  install(TARGETS ${ARG_PROGRAMS} DESTINATION lib/slam_core)
  install(EXPORT slam_core_targets NAMESPACE slam_core:: DESTINATION share/slam_core/cmake)
  if(catkin_FOUND)
    export(EXPORT slam_core_targets NAMESPACE slam_core::
           FILE ${CATKIN_DEVEL_PREFIX}/share/slam_core/cmake/slam_core_targets.cmake)
    install(FILES package.xml DESTINATION share/slam_core)
  endif()
endfunction()

# slam_core_tests(FILE... LINK target...): a GoogleTest program for each component that a file's path
# begins with; several calls may add to one. Nothing under BUILD_TESTING=OFF.
function(slam_core_tests)
  cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
  if(catkin_FOUND AND NOT CATKIN_ENABLE_TESTING)
    return()
  endif()
  if(NOT catkin_FOUND)
    if(NOT BUILD_TESTING)
      return()
    endif()
    find_package(GTest QUIET)
    if(NOT GTest_FOUND)
      message(WARNING "GoogleTest (libgtest-dev) is not here: slam_core is built without its tests")
      return()
    endif()
  endif()
  foreach(file IN LISTS ARG_UNPARSED_ARGUMENTS)
    string(REGEX REPLACE "/.*" "" component ${file})
    set(target slam_core_${component}_tests)
    if(TARGET ${target})
      target_sources(${target} PRIVATE ${file})
    else()
      slam_core_test_program(${target} ${file})
    endif()
    if(catkin_FOUND)
      target_link_libraries(${target} ${ARG_LINK})
    else()
      target_link_libraries(${target} PRIVATE ${ARG_LINK})
    endif()
  endforeach()
endfunction()

# A program of one file, to which slam_core_tests() adds the others.
function(slam_core_test_program target file)
  if(catkin_FOUND)
    catkin_add_gtest(${target} ${file})
    target_link_libraries(${target} slam_core_tuning ${GTEST_MAIN_LIBRARIES})
  else()
    add_executable(${target} ${file})
    target_link_libraries(${target} PRIVATE slam_core_tuning GTest::gtest_main)
    add_test(NAME ${target} COMMAND ${target})
  endif()
  # The time of the tests is spent in the libraries; -O1 compiles the tests in three quarters of the
  # time of -O3.
  target_compile_options(${target} PRIVATE -O1 -Wall -Wextra -Wpedantic -Wshadow
                         $<$<BOOL:${SLAM_WERROR}>:-Werror>)
endfunction()

# slam_core_fuzz_targets(FILE... [LINK ...]): fuzz targets, NAME of COMPONENT/test/fuzz/NAME.cpp with its inputs
# in the folder NAME beside it. Under SLAM_FUZZ each is a program slam_core_fuzz_NAME, for which
# libFuzzer makes up inputs; else all together are tests, which are given those inputs.
# LINK: what the targets need beside slam_core.
function(slam_core_fuzz_targets)
  cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
  if(catkin_FOUND OR NOT (SLAM_FUZZ OR TARGET slam_core_common_tests))
    return()
  endif()
  set(list ${CMAKE_CURRENT_BINARY_DIR}/fuzz_targets.txt)
  file(WRITE ${list} "")
  foreach(file IN LISTS ARG_UNPARSED_ARGUMENTS)
    get_filename_component(name ${file} NAME_WE)
    string(REGEX REPLACE "\\.cpp$" "" inputs ${CMAKE_CURRENT_SOURCE_DIR}/${file})
    file(APPEND ${list} "${name} ${inputs}\n")
    if(SLAM_FUZZ)
      add_executable(slam_core_fuzz_${name} ${file})
      slam_core_target(slam_core_fuzz_${name})
      target_compile_definitions(slam_core_fuzz_${name} PRIVATE SLAM_FUZZ)
      target_link_options(slam_core_fuzz_${name} PRIVATE -fsanitize=fuzzer)
      target_link_libraries(slam_core_fuzz_${name} PRIVATE slam_core_tuning ${ARG_LINK})
    endif()
  endforeach()
  if(NOT SLAM_FUZZ)
    slam_core_test_program(slam_core_fuzz_tests common/test/fuzz/fuzz_targets_test.cpp)
    target_sources(slam_core_fuzz_tests PRIVATE ${ARG_UNPARSED_ARGUMENTS})
    target_link_libraries(slam_core_fuzz_tests PRIVATE ${ARG_LINK})
    target_compile_definitions(slam_core_fuzz_tests PRIVATE FUZZ_TARGETS="${list}")
  endif()
endfunction()
