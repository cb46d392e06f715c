#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# check_layers.sh passes a clean tree and names every kind of forbidden include.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../support/script.sh"
readonly check=$here/check_layers.sh tree=$out
export LIGGGHTS_INCLUDE_DIR=$tree/engine
mkdir -p "$tree"/{engine,cmake,src/core/{args,math},src/app,fixes/{joints,output,engine},postproc/lib}
touch "$tree"/engine/{lammps.h,region.h} "$tree"/postproc/lib/region.h

echo '#include "args/range.h"
#include <vector>' >"$tree/src/core/args/a.cpp"
echo '#include <vtkPoints.h>
#include "region.h"' >"$tree/postproc/lib/b.cpp"
echo '#include <lammps.h>
#include <mpi.h>' >"$tree/fixes/c.cpp"
echo '#include "fixes/joints/fix_muckpile_joint.h"' >"$tree/fixes/joints/fix_muckpile_joint.cpp"
echo '#include "fixes/joints/fix_muckpile_joint.h"' >"$tree/fixes/engine/registry.cpp"
echo '__builtin_prefetch(place);' >"$tree/src/core/math/prefetch.h"
readonly headers=$tree/cmake/MuckpileTarget.cmake
printf 'set(muckpile_library_headers <vector>\n  <Eigen/Core>)\nset(muckpile_program_headers <vector> <iostream>)\n' >"$headers"
"$check" "$tree" || { echo "a clean tree was refused"; exit 1; }

expect_fault() {  # expect_fault FILE HEADER
  echo "#include $2" >"$tree/$1"
  if output=$("$check" "$tree"); then
    echo "$1 with $2 passed"
    exit 1
  fi
  grep -qF "$1:1 includes" <<<"$output" || { echo "wrong message: $output"; exit 1; }
  rm "$tree/$1"
}
expect_fault src/core/args/x.h '<lammps.h>'
expect_fault src/core/args/x.h '"liggghts/fix.h"'
expect_fault src/core/args/x.h '<mpi.h>'
expect_fault src/core/args/x.cpp '<vtkPoints.h>'
expect_fault src/core/args/x.cpp '<iostream>'
expect_fault src/core/args/x.cpp '"engine/style_args.h"'
expect_fault src/core/args/x.cpp '"interfaces/joint_view.h"'
expect_fault postproc/lib/x.cpp '<lammps.h>'
expect_fault postproc/lib/x.cpp '"fix_muckpile_joint.h"'
expect_fault fixes/x.cpp '<vtkPoints.h>'
expect_fault fixes/output/x.cpp '"fixes/joints/fix_muckpile_joint.h"'
expect_fault fixes/engine/x.cpp '"fixes/contact/pair_muckpile_block.h"'
expect_fault src/app/x.cpp '"postproc/lib/b.h"'

echo '__builtin_prefetch(place);' >"$tree/src/core/args/x.cpp"
output=$("$check" "$tree") && { echo "a prefetch of its own passed"; exit 1; }
grep -qF "src/core/args/x.cpp:1 calls" <<<"$output" || { echo "wrong message: $output"; exit 1; }
rm "$tree/src/core/args/x.cpp"

for header in '"math/types.h"' '<iostream>'; do
  printf 'set(muckpile_library_headers <vector>\n  %s)\n' "$header" >"$headers"
  output=$("$check" "$tree") && { echo "$header was precompiled for libraries"; exit 1; }
  grep -qF "precompiles $header" <<<"$output" || { echo "wrong message: $output"; exit 1; }
done
