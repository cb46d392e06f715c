# SPDX-License-Identifier: GPL-2.0-or-later
# muckpile_add_unit_test(<name> <sources>...): a GoogleTest program on the core, label `unit`.
find_package(GTest REQUIRED)
include(GoogleTest)

function(muckpile_add_unit_test name)
  add_executable(${name} ${ARGN})
  muckpile_target(${name})
  target_link_libraries(${name} PRIVATE muckpile::core GTest::gtest GTest::gtest_main)
  gtest_discover_tests(${name} PROPERTIES LABELS unit DISCOVERY_TIMEOUT 60)
endfunction()
