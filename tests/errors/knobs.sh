#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# knobs.sh LIGGGHTS_MUCKPILE INPUT [-var NAME VALUE]...: every knob of INPUT and of the files that it includes must refuse
# `nan` and 1e300 by its name, before any step. The variables make the case small: some knobs are seen when the rock is cut.
# Scope: knobs that are names of files, regions or other words than choices are left out (kWords).
set -euo pipefail
program=$1 input=$2
shift 2
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
readonly kWords=' out from holes_by holes_of hole_table pulse_table gas_file '
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
mkdir "$out/dump"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

knobs_of() {  # knobs_of FILE: of it and what it includes; of all variants where the file's name has a variable in it
  local pattern file
  sed -nE 's/^[[:space:]]*variable[[:space:]]+([A-Za-z0-9_]+)[[:space:]]+index[[:space:]]+[^[:space:]]+[[:space:]]*(#.*)?$/\1/p' "$1"
  while read -r pattern; do
    for file in $pattern; do knobs_of "$file"; done
  done < <(sed -nE 's/^[[:space:]]*include[[:space:]]+([^[:space:]]+).*/\1/p' "$1" | sed -E 's/\$\{[^}]*\}/*/g')
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
done < <(knobs_of "$input" | sort -u)
echo "$tried values tried"
[[ $tried -ge 20 ]] || { echo "too few knobs found in $input"; wrong=1; }
exit $wrong
