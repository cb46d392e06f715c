#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Fails if a source file under the folder $1 includes what its layer must not know.
# Rule: src/core knows no engine, MPI, VTK, printing or upper layer; postproc no engine, MPI or
# fixes; fixes no postproc. The engine's headers are those that LIGGGHTS installs.
set -euo pipefail
root=$1
engine_dir=${LIGGGHTS_INCLUDE_DIR:-/usr/include/liggghts}
faults=0

# "file:line: header" of each include under a layer.
includes_of() {
  [[ -d $root/$1 ]] || return 0
  grep -rnE --include='*.h' --include='*.cpp' '^[[:space:]]*#[[:space:]]*include' "$root/$1" |
    sed -nE 's/^([^:]*:[0-9]*):[^<"]*[<"]([^>"]*)[>"].*/\1: \2/p'
}

is_engine_header() { [[ $1 == liggghts/* || ($1 != */* && -f $engine_dir/$1) ]]; }
# Headers of the C and C++ libraries or our own may share a name with the engine's.
is_own_header() { [[ -f $root/$1/$2 || -f $(dirname "$3")/$2 ]]; }

report() {
  printf '%s includes %s\n' "${1#"$root"/}" "$2"
  faults=$((faults + 1))
}

check() {  # check LAYER FORBIDDEN_REGEX ENGINE_ALLOWED
  local layer=$1 forbidden=$2 engine_allowed=$3 place header
  while IFS=' ' read -r place header; do
    place=${place%:}
    if [[ $header =~ $forbidden ]]; then
      report "$place" "$header"
    elif [[ $engine_allowed == no ]] && is_engine_header "$header" &&
      ! is_own_header "$layer" "$header" "${place%%:*}"; then
      report "$place" "$header"
    fi
  done < <(includes_of "$layer")
}

check src/core '^(mpi\.h|vtk|iostream$|cstdio$|stdio\.h|engine/|interfaces/|fixes/|postproc/|fix_|pair_)' no
check postproc '^(mpi\.h|engine/|interfaces/|fixes/|fix_|pair_)' no
check fixes '^(vtk|postproc/)' yes
check src/app '^(vtk|postproc/)' yes
[[ $faults -eq 0 ]]
