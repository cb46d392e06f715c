#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# one_run.sh LIGGGHTS_MUCKPILE INPUT EVERY TIME_END LATER [-var NAME VALUE]...: a run of INPUT, and what goes on from its restart file, are one
# run: it ends within a few steps of TIME_END, the history with it, and every file carries one id. To go on with another seed, or in the folder
# of another run, is refused before any result is written; with another spelling of it, and to LATER, it is not.
# Scope: INPUT offers go_on and from (inputs/common/box_or_restart.in). Two ranks.
set -euo pipefail
program=$1 input=$2 every=$3 time_end=$4 later=$5
shift 5
source "$(dirname "${BASH_SOURCE[0]}")/runs.sh"
readonly dump=$out/run/dump

ends_at() {  # ends_at SECONDS
  check_figures near "time [s]" "$dump/run.json:physical_time_s" "$1" 2e-3
  check_figures near "time of the last row [s]" "$dump/history.csv:time_s" "$(of_run run physical_time_s)" 1e-9  # ten digits
}
ids() {
  sed -nE '2s/.* run=//p' "$dump/blocks.vtk"
  sed -s -nE '1s/.* run=//p' "$dump"/blocks_*.csv
  sed -nE 's/^ *"run_id": "(.*)".*/\1/p' "$dump/scene.json" "$dump/run.json"
  sed -nE '2,$s/.*,//p' "$dump/history.csv"
}
one_id() {  # prints it, or what is wrong
  local found files
  found=$(ids)
  files=$(find "$dump" -name 'blocks_*.csv' | wc -l)
  # blocks.vtk, two JSON files, and the history without its header
  [[ $(wc -l <<<"$found") -eq $((files + $(wc -l <"$dump/history.csv") + 2)) ]] || { echo "files without an id:" "$found"; return; }
  sort -u <<<"$found"
}

run_input run 2 "$input" "$@" -var time_end "$time_end" -var restart_every "$every"
ends_at "$time_end"
id=$(one_id)
[[ $id =~ ^[0-9a-f]{16}$ ]] || fail "not one id: $id"
older=$dump/a.restart
if [[ $dump/b.restart -ot $older ]]; then older=$dump/b.restart; fi
cp "$older" "$out/from.restart"

before=$(cd "$dump" && md5sum -- *.json history.csv blocks_*.csv)
if (run_input run 2 "$input" -var seed 7 "$@" -var go_on 1 -var from "$out/from.restart") >"$out/refused"; then fail "another seed was accepted"; fi
grep '^ERROR' "$out/refused" | grep -q "seed '7' (was '1')" || fail "another seed was not refused by its name: $(grep ERROR "$out/refused")"
[[ $(cd "$dump" && md5sum -- *.json history.csv blocks_*.csv) == "$before" ]] || fail "a refused run has written files"

# Nor does it go on over the results of another run.
cp -r "$out/run" "$out/other"
sed -i "s/$id/0123456789abcdef/" "$out"/other/dump/*.json "$out"/other/dump/history.csv
others=$(cd "$out/other/dump" && md5sum -- *.json history.csv blocks_*.csv)
if (run_input other 2 "$input" "$@" -var time_end "$later" -var go_on 1 -var from "$out/from.restart") >"$out/refused"; then fail "it went on over another run"; fi
grep '^ERROR' "$out/refused" | grep -q "must be of the run that goes on, $id, or not be there, got the scene of another run, 0123456789abcdef" || fail "another run is not told of: $(grep ERROR "$out/refused")"
[[ $(cd "$out/other/dump" && md5sum -- *.json history.csv blocks_*.csv) == "$others" ]] || fail "a run that is refused has changed the results of another"

run_input run 2 "$input" -var seed +1 "$@" -var time_end "$later" -var go_on 1 -var from "$out/from.restart"
! grep -q 'knobs of the restart file' "$out/run/screen" || fail "knobs are told that are the same"
ends_at "$later"
[[ $(one_id) == "$id" ]] || fail "the id is no longer $id: $(one_id)"
