#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# run_case.sh LIGGGHTS_MUCKPILE MUCKPILE_POST INPUT REPORTS EXPECTED.json [RANKS]: runs INPUT with the "vars" of EXPECTED.json
# on 2 ranks or RANKS, lets muckpile-post make the REPORTS, and compares summary.json, or the last row of history.csv, with the "expected" lines.
# Scope: EXPECTED.json has one line per value: {"quantity": NAME, "value": V, "tolerance": T, "why": TEXT}.
set -euo pipefail
program=$1 post=$2 input=$3 expected=$(readlink -f "$5") ranks=${6:-2}
read -ra reports <<<"$4"
source "$(dirname "${BASH_SOURCE[0]}")/runs.sh"

grep -qE '^ *"vars": ".*",?$' "$expected" || { echo "$expected: no line with \"vars\""; exit 1; }
read -ra vars < <(sed -nE 's/^ *"vars": "(.*)",?$/\1/p' "$expected")

run_input run "$ranks" "$input" "${vars[@]}"
for report in "${reports[@]}"; do "$post" "$report" "$out/run"; done

value_of() {  # value_of QUANTITY: from summary.json, else the last row of history.csv, else nothing
  local found
  found=$(sed -nE "s/^ *\"$1\": ([-0-9.eE+]+),?$/\1/p" "$out/run/summary.json")
  [[ -n $found ]] || found=$(awk -F, -v name="$1" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) column = i }
    END { if (column) print $column }' "$out/run/dump/history.csv")
  printf '%s' "$found"
}

compared=0 wrong=0
while read -r quantity value tolerance; do
  found=$(value_of "$quantity")
  compared=$((compared + 1))
  verdict=$(awk -v f="${found:-missing}" -v v="$value" -v t="$tolerance" 'BEGIN {
    d = f - v; if (f == "missing") print "missing"; else if (d <= t && -d <= t) print "ok"; else print "WRONG" }')
  printf '%-28s %14s  expected %s +- %s  %s\n' "$quantity" "${found:-missing}" "$value" "$tolerance" "$verdict"
  [[ $verdict == ok ]] || wrong=$((wrong + 1))
done < <(sed -nE \
  's/^ *\{"quantity": "([a-zA-Z0-9_]+)", "value": ([-0-9.eE+]+), "tolerance": ([-0-9.eE+]+), "why": ".+"\},?$/\1 \2 \3/p' \
  "$expected")
[[ $compared -gt 0 ]] || { echo "$expected: no line with \"quantity\""; exit 1; }
[[ $wrong -eq 0 ]]
