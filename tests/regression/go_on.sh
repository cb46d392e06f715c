#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# go_on.sh LIGGGHTS_MUCKPILE INPUT EVERY [-var NAME VALUE]...: runs INPUT with a restart file every so many steps, goes on from the
# one before the last, and compares how the two runs end: the work of the blast, broken joints, blocks and time.
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
run_input run 2 "$input" "$@" -var go_on 1 -var from "$out/from.restart"
grep -q 'read_restart\|Reading restart file' "$out/run/screen" || { echo "no restart file was read"; exit 1; }
balance=$(of_run run energy_balance_error)
printf '%s\n' "blast work [J], broken share, blocks, time [s]" "in one run:    $whole" "from the file: $(end_of_run)"
echo "energy balance error from the file: $balance; rows of the history: $rows, $(wc -l <"$dump/history.csv")"
# Ranks add up in another order: chaos shifts what breaks late. The blast's work is done by then. A run looks every 0.1 s
# whether time_end is over.
awk -v a="$whole" -v b="$(end_of_run)" -v balance="$balance" 'BEGIN {
  if (split(a, x) != 4 || split(b, y) != 4 || balance == "") { print "figures are missing"; exit 1 }
  off(x[1], y[1], 0.02 * x[1]); off(x[2], y[2], 0.02); off(x[3], y[3], 0); off(x[4], y[4], 0.11); off(balance, 0, 0.01)
  exit wrong }
  function off(p, q, most) { if (!(p - q <= most && q - p <= most)) { print p " and " q " differ by more than " most; wrong = 1 } }'
