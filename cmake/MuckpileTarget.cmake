# SPDX-License-Identifier: GPL-2.0-or-later
# GCC 12 takes its own AVX-512 intrinsics under Eigen's sums for uninitialized (GCC bug 105593).
set(muckpile_false_warnings
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-maybe-uninitialized>)

# muckpile_compile_options(<target>): C++20, warnings and sanitizers as the options say.
function(muckpile_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion -Wshadow ${muckpile_false_warnings}
    -fno-math-errno -fno-trapping-math
    "-fmacro-prefix-map=${PROJECT_SOURCE_DIR}/="
    $<$<BOOL:${MUCKPILE_WARNINGS_AS_ERRORS}>:-Werror>)
  # Of its users, too: headers and Eigen lay out data by the width of the processor's vectors.
  target_compile_options(${target} PUBLIC $<$<BOOL:${MUCKPILE_NATIVE}>:-march=native>)
  if(MUCKPILE_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=address,undefined -fno-sanitize-recover=all
                           -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=address,undefined)
  endif()
endfunction()

# What many files include of others' headers, precompiled once for each kind of target, as reading them takes the time. Our own
# headers are not among these: the warnings about them would be lost.
set(muckpile_library_headers <algorithm> <array> <charconv> <cmath> <filesystem> <fstream> <functional> <limits> <map> <memory>
  <numbers> <numeric> <optional> <random> <set> <span> <sstream> <string> <utility> <variant> <vector>
  <experimental/simd> <Eigen/Core> <Eigen/Geometry>)
set(muckpile_program_headers ${muckpile_library_headers} <iostream> <nlohmann/json.hpp>)
set(muckpile_test_headers ${muckpile_library_headers} <iostream> <gtest/gtest.h>)

# muckpile_precompile(<kind>): the target muckpile_headers_<kind> has the headers of that kind. It defines no macro that others do not:
# GCC would refuse them there.
function(muckpile_precompile kind)
  set(source "${PROJECT_BINARY_DIR}/precompiled/${kind}.cpp")
  file(CONFIGURE OUTPUT "${source}" CONTENT "int main() { return 0; }\n")
  if(kind STREQUAL library)
    add_library(muckpile_headers_${kind} STATIC EXCLUDE_FROM_ALL "${source}")
  else()
    add_executable(muckpile_headers_${kind} EXCLUDE_FROM_ALL "${source}")  # position independent as programs are, which differs
  endif()
  muckpile_compile_options(muckpile_headers_${kind})
  target_precompile_headers(muckpile_headers_${kind} PRIVATE ${muckpile_${kind}_headers})
  target_link_libraries(muckpile_headers_${kind} PRIVATE Eigen3::Eigen
    $<$<STREQUAL:${kind},program>:nlohmann_json::nlohmann_json> $<$<STREQUAL:${kind},test>:GTest::gtest>)
endfunction()

# muckpile_target(<target> [<kind>]): what all of our own targets have. The kind (library, program, test) tells which headers are
# precompiled for it; library or program by what the target is, unless given.
function(muckpile_target target)
  muckpile_compile_options(${target})
  if(NOT MUCKPILE_QUICK_BUILD)
    return()
  endif()
  set(kind library)
  get_target_property(type ${target} TYPE)
  if(ARGC GREATER 1)
    set(kind ${ARGV1})
  elseif(type STREQUAL EXECUTABLE)
    set(kind program)
  endif()
  if(NOT TARGET muckpile_headers_${kind})
    muckpile_precompile(${kind})
  endif()
  target_precompile_headers(${target} REUSE_FROM muckpile_headers_${kind})
endfunction()
