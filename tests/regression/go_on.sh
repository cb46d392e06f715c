#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# go_on.sh LIGGGHTS_MUCKPILE INPUT EVERY [-var NAME VALUE]...: runs INPUT with a restart file every so many steps, goes on from the
# one before the last, and compares how the two runs end: the work of the blast, broken joints, blocks and time. Both end at time_end,
# which is among the variables, and all files carry one run id. Going on with another seed is refused before anything is written.
# Scope: INPUT offers go_on and from (inputs/common/box_or_restart.in). One rank writes the file, two go on from it.
set -euo pipefail
program=$1 input=$2 every=$3
shift 3
source "$(dirname "${BASH_SOURCE[0]}")/runs.sh"
readonly dump=$out/run/dump

last() { awk -F, -v name="$1" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i } END { print $c }' "$dump/history.csv"; }
end_of_run() {
  echo "$(last blast_work_J) $(of_run run joints_broken_fraction) $(of_run run blocks) $(of_run run physical_time_s)"
}

run_input run 1 "$input" "$@" -var restart_every "$every"
whole=$(end_of_run)
rows=$(wc -l <"$dump/history.csv")
[[ -s $dump/a.restart && -s $dump/b.restart ]] || { echo "no two restart files"; exit 1; }
older=$dump/a.restart
if [[ $dump/b.restart -ot $older ]]; then older=$dump/b.restart; fi
cp "$older" "$out/from.restart"
rm -f "$dump/run.json"
with_another_seed() {
  mpirun -np 2 --oversubscribe --bind-to none "$program" -in "$input" -log none -var out "$out/run" -var seed 7 "$@" \
    -var go_on 1 -var from "$out/from.restart" >"$out/refused" 2>&1
}
scene=$(<"$dump/scene.json")
if with_another_seed "$@"; then echo "another seed was accepted"; exit 1; fi
grep '^ERROR' "$out/refused" | grep -q "seed '7' (was '1')" || { echo "another seed was not refused by its name"; tail -n 3 "$out/refused"; exit 1; }
[[ $(<"$dump/scene.json") == "$scene" && ! -f $dump/run.json ]] || { echo "a refused run has written files"; exit 1; }

run_input run 2 "$input" "$@" -var go_on 1 -var from "$out/from.restart"
grep -q 'read_restart\|Reading restart file' "$out/run/screen" || { echo "no restart file was read"; exit 1; }
ids=$({ sed -nE '2s/.* run=//p' "$dump/blocks.vtk"; sed -nE '1s/.* run=//p' "$dump"/blocks_*.csv -s; sed -nE 's/.*"run_id": "(.*)".*/\1/p' "$dump"/*.json
  sed -nE '2,$s/.*,//p' "$dump/history.csv"; } | sort -u)
[[ $ids =~ ^[0-9a-f]{16}$ ]] || { echo "files of more than one run: $ids"; exit 1; }
[[ $(last step) == "$(of_run run steps)" ]] || { echo "the history ends at step $(last step), the run at $(of_run run steps)"; exit 1; }
balance=$(of_run run energy_balance_error)
time_end=$(sed -nE 's/^ *"time_end": ([0-9.]+),?$/\1/p' "$dump/scene.json")
printf '%s\n' "blast work [J], broken share, blocks, time [s]" "in one run:    $whole" "from the file: $(end_of_run)"
echo "energy balance error from the file: $balance; rows of the history: $rows, $(wc -l <"$dump/history.csv")"
# Ranks add up in another order: chaos shifts what breaks late. The blast's work is done by then. A run ends within a
# few steps of time_end.
awk -v a="$whole" -v b="$(end_of_run)" -v balance="$balance" -v time_end="$time_end" 'BEGIN {
  if (split(a, x) != 4 || split(b, y) != 4 || balance == "" || time_end == "") { print "figures are missing"; exit 1 }
  off(x[1], y[1], 0.02 * x[1]); off(x[2], y[2], 0.02); off(x[3], y[3], 0); off(balance, 0, 0.01)
  off(x[4], time_end, 2e-3); off(y[4], time_end, 2e-3)
  exit wrong }
  function off(p, q, most) { if (!(p - q <= most && q - p <= most)) { print p " and " q " differ by more than " most; wrong = 1 } }'
