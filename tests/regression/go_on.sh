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

end_of_run() {
  check_figures print "$dump/history.csv:blast_work_J" "$dump/run.json:joints_broken_fraction" "$dump/run.json:blocks" "$dump/run.json:physical_time_s"
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
echo "rows of the history: $rows in one run, $(wc -l <"$dump/history.csv") from the file"
# Ranks add up in another order: chaos shifts what breaks late. The blast's work is done by then. A run ends within a
# few steps of time_end.
read -r work broken blocks time <<<"$whole"
wrong=0
check_figures near "work of the blast [J]" "$dump/history.csv:blast_work_J" "$work" 0.02 --share || wrong=1
check_figures near "broken share of the joints" "$dump/run.json:joints_broken_fraction" "$broken" 0.02 || wrong=1
check_figures near "blocks" "$dump/run.json:blocks" "$blocks" 0 || wrong=1
check_figures near "time [s]" "$dump/run.json:physical_time_s" "$time" 2e-3 || wrong=1
check_figures near "energy balance error" "$dump/run.json:energy_balance_error" 0 0.01 || wrong=1
exit $wrong
