#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# test_files_kept.sh LIGGGHTS_MUCKPILE: what stays of files that a run would replace: all where a fix that is set up behind the outputs refuses the
# run, the rows ahead of a damaged one, the old text where the disk is full, and
# the folder of another run.
set -euo pipefail
program=$1
source "$(dirname "${BASH_SOURCE[0]}")/../support/script.sh"
cd "$out"

run() {  # run STATUS: the script on standard input behind the rock
  { printf '%s\n' "variable dir index $here" "variable bodies index multisphere/muckpile" "include $here/joined_rock.in"; cat; } >in.try
  status=0
  on_ranks 2 -in in.try -log none >screen 2>&1 </dev/null || status=$?
  [[ $status -eq $1 || ($1 -ne 0 && $status -ne 0) ]] || fail "exit status $status"
}
says() { grep -qF -- "$1" screen || fail "does not say: $1"; }
outputs='fix energy all muckpile/ledger
fix snapshots all muckpile/dump every 2 directory dump
fix progress all muckpile/progress every 2 directory dump
timestep 1e-6'
sums() { (cd dump && md5sum -- *); }

run 0 <<<"$outputs
run 5"
before=$(sums)
[[ $(wc -l <<<"$before") -eq 7 ]] || fail "not four snapshots, a history, joints and a run.json: $before"
run 1 <<<"$outputs
fix dt all muckpile/timestep min 0.01
run 5"
says "shorter than min"
[[ $(sums) == "$before" ]] || fail "a refused run has changed files: $(ls dump)"
run 0 <<<"$outputs
run 1"
[[ $(ls dump) == $'blocks_000000000.csv\nblocks_000000001.csv\nhistory.csv\njoints.csv\nrun.json' ]] || fail "the same run, shorter, left files: $(ls dump)"

# One row cut off, one snapshot of another run: each told of once.
echo '4,4e-' >cut_row
echo '# step=7 time_s=1 run=0123456789abcdef' >dump/blocks_000000007.csv
run 0 <<<"$outputs
run 3
shell cat cut_row >> dump/history.csv
unfix progress
fix progress all muckpile/progress every 2 directory dump
run 2
run 2"
[[ $(grep -c 'WARNING.*history.csv. goes on without its last 1 rows' screen) -eq 1 ]] || fail "not one warning of the cut row"
[[ $(grep -c 'WARNING.*holds 1 snapshots of other runs' screen) -eq 1 ]] || fail "not one warning of the other run"
[[ $(cut -d , -f 1 dump/history.csv | xargs) == 'step 0 2 3 4 5 6 7' ]] || fail "rows: $(cut -d , -f 1 dump/history.csv | xargs)"

echo old >scene.json
ln -s /dev/full scene.json.part
run 1 <<<'write_scene scene.json case bench burden_m 3'
says "write_scene: 'scene.json' cannot be written: No space left on device"
[[ $(cat scene.json) == old ]] || fail "a full disk took the old file"
[[ ! -L scene.json.part ]] || fail "what was written of the new file stayed"

# Inputs that write a table of holes before the rock is there look first whose folder it is.
mkdir -p other/dump
echo '{"run_id": "0123456789abcdef"}' >other/dump/scene.json
echo 'of no run' >a.restart
for input in quarry pattern; do
  status=0
  (cd "$root" && "$program" -in "inputs/$input/in.$input" -log none -var out "$out/other" -var go_on 1 -var from "$out/a.restart") >screen 2>&1 </dev/null || status=$?
  [[ $status -eq 1 ]] || fail "$input: exit status $status"
  says "input: out must be the folder of the run that goes on from '$out/a.restart', or a new one, got '$out/other', which has the scene of another run, 0123456789abcdef"
  [[ $(ls other/dump) == scene.json ]] || fail "$input has written into the folder of another run: $(ls other/dump)"
done
