# SPDX-License-Identifier: GPL-2.0-or-later
# muckpile_add_unit_test(<name> <sources>...): a GoogleTest program on the core, label `unit`.
# muckpile_add_engine_test(<name> RANKS <n>... SOURCES <file>... [LABEL <label>] [FILTER_<n> <filter>]...):
#   a GoogleTest program on LIGGGHTS (tests/support/mpi_main.cpp), run on each number of ranks as <label>.<name>.np<n>;
#   FILTER_<n> chooses its tests at n ranks as --gtest_filter does. The label is `styles` unless given.
find_package(GTest REQUIRED)
include(GoogleTest)

# Containers run as root and forbid Open MPI's single-copy mechanism; ranks that wait give way, as there may be fewer
# cores than ranks.
set(MUCKPILE_MPI_ENVIRONMENT
  OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  OMPI_MCA_btl_vader_single_copy_mechanism=none OMPI_MCA_mpi_yield_when_idle=1)

function(muckpile_add_unit_test name)
  add_executable(${name} ${ARGN})
  muckpile_target(${name} test)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests/support)
  target_link_libraries(${name} PRIVATE muckpile::core GTest::gtest GTest::gtest_main)
  gtest_discover_tests(${name} PROPERTIES LABELS unit DISCOVERY_TIMEOUT 60)
endfunction()

function(muckpile_add_engine_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "LABEL;FILTER_1;FILTER_2;FILTER_4" "RANKS;SOURCES")
  if(arg_UNPARSED_ARGUMENTS OR NOT arg_RANKS OR NOT arg_SOURCES)
    message(FATAL_ERROR "muckpile_add_engine_test(${name}): needs RANKS and SOURCES, got '${ARGN}'")
  endif()
  if(NOT arg_LABEL)
    set(arg_LABEL styles)
  endif()
  add_executable(test_${name} ${arg_SOURCES})
  muckpile_target(test_${name} test)
  target_link_libraries(test_${name} PRIVATE muckpile_engine_testing)
  foreach(ranks IN LISTS arg_RANKS)
    set(filter "*")
    if(DEFINED arg_FILTER_${ranks})
      set(filter "${arg_FILTER_${ranks}}")
    endif()
    add_test(NAME ${arg_LABEL}.${name}.np${ranks}
      COMMAND ${MPIEXEC_EXECUTABLE} ${MPIEXEC_NUMPROC_FLAG} ${ranks} --oversubscribe --bind-to none
        $<TARGET_FILE:test_${name}> --gtest_filter=${filter})
    set_tests_properties(${arg_LABEL}.${name}.np${ranks} PROPERTIES
      LABELS ${arg_LABEL} PROCESSORS ${ranks} TIMEOUT 300 ENVIRONMENT "${MUCKPILE_MPI_ENVIRONMENT}")
  endforeach()
endfunction()
