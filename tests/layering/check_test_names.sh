#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Fails if two unit tests of an area under the folder $1, which are linked into one program, could define the same thing: what a
# test_*.cpp defines stands in its unnamed namespace. Types alone may stand outside, for what is specialised for them, and have another
# name in each file of the area: the linker tells nothing of two that have the same.
# Scope: tests/unit; by lines, as clang-format lays them out.
set -euo pipefail
cd "$1"

# "AREA FILE:LINE text" of each definition that begins outside.
outside() {
  find tests/unit -name 'test_*.cpp' -print0 | sort -z | xargs -0 -r awk '
    FNR == 1 { inside = 0 }
    /^namespace \{/ { inside = 1 }
    /^\}  \/\/ namespace$/ { inside = 0 }
    inside || /^$|^[ \t})#]|^\/\// || /^namespace [a-z:]+ \{/ || /^TEST(_[FP])?\(/ { next }
    /^using namespace / || /^template <>$/ || /^(struct|class) [A-Za-z]+</ { next }
    { split(FILENAME, part, "/"); print part[3], FILENAME ":" FNR, $0 }'
}

faults=0
declare -A seen=()
while read -r area place text; do
  [[ -n $area ]] || continue
  if [[ ! $text =~ ^(struct|class|enum\ class|enum)\ ([A-Za-z_]+)[\ ] ]]; then
    printf '%s is outside the unnamed namespace: %s\n' "$place" "$text"
    faults=$((faults + 1))
    continue
  fi
  key="$area ${BASH_REMATCH[2]}"
  if [[ -n ${seen[$key]:-} ]]; then
    printf '%s: %s is the name of a type in %s, too\n' "$place" "${BASH_REMATCH[2]}" "${seen[$key]}"
    faults=$((faults + 1))
  fi
  seen[$key]=$place
done < <(outside)
[[ $faults -eq 0 ]]
