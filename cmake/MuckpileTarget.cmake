# SPDX-License-Identifier: GPL-2.0-or-later
# GCC 12 takes its own AVX-512 intrinsics under Eigen's sums for uninitialized (GCC bug 105593).
set(muckpile_false_warnings
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-maybe-uninitialized>)

# muckpile_target(<target>): C++20, warnings and sanitizers as the options say, for one of our own targets.
function(muckpile_target target)
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
