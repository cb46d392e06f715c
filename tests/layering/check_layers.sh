#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Fails if a source file under the folder $1 includes what its layer must not know, or prefetches by itself.
# Rule: src/core knows no engine, MPI, VTK, printing or upper layer; postproc no engine, MPI or
# fixes; fixes no postproc. The engine's headers are those that LIGGGHTS installs. A style's header is included in its own folder
# alone, and where styles are registered: other styles see it through fixes/interfaces.
# What is precompiled are headers of others, and for libraries none that core must not know: it would compile with it unseen.
# Memory is prefetched through src/core/math/prefetch.h, as GCC may drop what calls the builtin itself.
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

check_styles() {
  local place header folder
  while IFS=' ' read -r place header; do
    [[ $header =~ ^fixes/([a-z]+)/(fix|pair)_[a-z_]*\.h$ && ${BASH_REMATCH[1]} != engine ]] || continue
    folder=${BASH_REMATCH[1]}
    case ${place#"$root"/fixes/} in
      "$folder"/* | engine/registry.cpp:*) ;;
      *) report "${place%:}" "$header" ;;
    esac
  done < <(includes_of fixes)
}

check_prefetches() {
  local place
  while IFS= read -r place; do
    printf '%s calls __builtin_prefetch, not math/prefetch.h\n' "${place#"$root"/}"
    faults=$((faults + 1))
  done < <(grep -rnF __builtin_prefetch "$root"/{src,fixes,postproc} | grep -v '/math/prefetch\.h:' | cut -d: -f1,2)
}

headers_of() { sed -n "/^set(muckpile_$1_headers/,/)/p" "$root/cmake/MuckpileTarget.cmake" 2>/dev/null || true; }

check_precompiled() {
  local header
  while IFS= read -r header; do
    printf 'cmake/MuckpileTarget.cmake precompiles %s\n' "$header"
    faults=$((faults + 1))
  done < <(
    headers_of '[a-z]*' | grep -oE '"[^"]+"' || true
    headers_of library | grep -oE '<(mpi\.h|vtk[^>]*|iostream|cstdio|stdio\.h|lammps\.h|gtest/[^>]*)>' || true
  )
}

check src/core '^(mpi\.h|vtk|iostream$|cstdio$|stdio\.h|engine/|interfaces/|fixes/|postproc/|fix_|pair_)' no
check postproc '^(mpi\.h|engine/|interfaces/|fixes/|fix_|pair_)' no
check fixes '^(vtk|postproc/)' yes
check src/app '^(vtk|postproc/)' yes
check_styles
check_prefetches
check_precompiled
[[ $faults -eq 0 ]]
