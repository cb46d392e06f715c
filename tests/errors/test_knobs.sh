#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# test_knobs.sh LIGGGHTS_MUCKPILE INPUT [-var NAME VALUE]...: every knob of INPUT and of the files that it includes must refuse
# `nan` and 1e300 by its name, before any step. The variables make the case small: some knobs are seen when the rock is cut.
# Scope: knobs that are names of files, regions or other words than choices are left out (kWords). Those of files that the bench
# includes, too, are tried with the bench alone.
set -euo pipefail
program=$1 input=$2
shift 2
source "$(dirname "${BASH_SOURCE[0]}")/../support/script.sh"
cd "$root"
source src/app/run/input_variables.sh
readonly kWords=' out site from holes_by holes_of hole_table pulse_table gas_file '
mkdir "$out/dump"
export OMPI_MCA_ess_singleton_isolated=1  # hundreds of runs on one rank, each of which would start Open MPI's daemon

readonly bench=inputs/bench/in.bench
files() { files_of "$1" | sort -u; }

knobs() {  # of the input and what it includes, with one value each
  comm -23 <(files "$input") <([[ $input == "$bench" ]] || files $bench) | xargs -d '\n' sed -nE 's/^[[:space:]]*variable[[:space:]]+([A-Za-z0-9_]+)[[:space:]]+index[[:space:]]+[^[:space:]]+[[:space:]]*(#.*)?$/\1/p' |
    sort -u
}

wrong=0 tried=0
refuses() {  # refuses KNOB VALUE [-var NAME VALUE]...
  local knob=$1 value=$2 status=0
  shift 2
  tried=$((tried + 1))
  # The first -var of a name counts.
  timeout -k 5 60 "$program" -in "$input" -log none -var out "$out" -var "$knob" "$value" "$@" >"$out/screen" 2>&1 || status=$?
  if [[ $status -eq 1 ]] && grep '^ERROR' "$out/screen" | grep -qE "(^|[^A-Za-z0-9_])$knob([^A-Za-z0-9_]|_$value|$)" && ! grep -qE '^ *Step |^Loop time' "$out/screen"; then
    return
  fi
  echo "$knob $value: exit status $status, $(grep '^ERROR' "$out/screen" || tail -n 1 "$out/screen")"
  wrong=1
}

while read -r knob; do
  [[ $kWords != *" $knob "* ]] || continue
  # What the case computes itself is no knob of it.
  ! grep -qsE "^variable[[:space:]]+$knob[[:space:]]+(equal|string)" "$input" "$(dirname "$input")/geometry.in" || continue
  refuses "$knob" nan "$@"
  refuses "$knob" 1e300 "$@"
done < <(knobs)
echo "$tried values tried"
[[ $tried -ge 40 ]] || { echo "too few knobs found in $input"; wrong=1; }
exit $wrong
