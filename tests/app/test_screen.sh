#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# test_screen.sh PROGRAM: a run that reads a mesh ends well whatever -screen says, and prints nothing with `-screen none`; so on two ranks.
set -euo pipefail
program=$1
source "$(dirname "${BASH_SOURCE[0]}")/../support/script.sh"
cd "$out"

cat >floor.stl <<'EOF'
solid floor
facet normal 0 0 1
outer loop
vertex -1 -1 0
vertex 1 -1 0
vertex 0 1 0
endloop
endfacet
endsolid floor
EOF
cat >in.mesh <<'EOF'
units si
atom_style granular
atom_modify map array sort 0 0
boundary f f f
newton off
communicate single vel yes
region box block -2 2 -2 2 -2 2 units box
create_box 1 box
neighbor 0.1 bin
fix floor all mesh/surface file floor.stl type 1
run 0
print "it has run" file ran.txt
EOF

run() {  # run OPTION...: what the program prints; MPI's own remarks go to stderr
  rm -f ran.txt
  output=$("${launcher[@]}" "$program" -in in.mesh -log none "$@" 2>stderr </dev/null) || fail "$*: exit status $?; $(cat stderr)"
  [[ -s ran.txt ]] || fail "$*: not run to the end"
}

launcher=()
run -screen none
[[ -z $output ]] || fail "-screen none prints"
run -screen out.txt
grep -q 'Reading STL file' out.txt || fail "-screen FILE lacks the output"
launcher=(mpirun -np 2 --bind-to none --oversubscribe)
run -screen two.txt
[[ -z $output ]] || fail "-screen FILE prints on two ranks"
grep -q 'Reading STL file' two.txt || fail "-screen FILE lacks the output of two ranks"
