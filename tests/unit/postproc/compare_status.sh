#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# compare_status.sh MUCKPILE_POST: exit status and table of `muckpile-post compare`.
# Scope: the command line; test_compare.cpp tests what counts as the same.
set -euo pipefail
program=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
echo '{"case": "bench", "throw_cg_m": 8.0, "pile_toe_m": 20.0}' >a.json
echo '{"case": "bench", "throw_cg_m": 8.4, "pile_toe_m": 20.0}' >b.json
echo '{"case": "bench", "throw_cg_m"' >cut.json

expect() {  # expect STATUS TEXT WORDS...
  local wanted=$1 text=$2 status=0 output
  shift 2
  output=$("$program" compare "$@" 2>&1) || status=$?
  [[ $status -eq $wanted && $output == *"$text"* ]] ||
    { printf 'compare %s: status %s (wanted %s), output without "%s":\n%s\n' "$*" "$status" "$wanted" "$text" "$output" && exit 1; }
}

expect 0 '3 quantities, 0 differ' a.json a.json
expect 1 'difference 0.4, allowed 0  DIFFERS' a.json b.json
expect 0 '3 quantities, 0 differ' a.json b.json --relative 0.06
expect 0 'pile_toe_m' a.json b.json --absolute 0.5 --all
expect 1 '1 differ' a.json b.json --absolute 0.5 --tolerance throw_cg_m=0,0.3
expect 2 'cut.json: ' a.json cut.json
expect 2 'nowhere/summary.json: cannot be opened' a.json nowhere/summary.json
expect 2 "did you mean 'throw_cg_m'" a.json b.json --ignore throw_c_m
expect 105 "must be >= 0, got '-1'" a.json b.json --relative -1
expect 1 '1 differ' a.json b.json --csv rows.csv
diff rows.csv - <<'CSV'
quantity,a,b,difference,allowed,place,same
case,bench,bench,,,,1
pile_toe_m,20,20,0,0,,1
throw_cg_m,8,8.4,0.40000000000000036,0,,0
CSV
