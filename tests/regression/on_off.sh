#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# on_off.sh LIGGGHTS_MUCKPILE "-var NAME VALUE" WORK SPEED STEPS INPUT [-var NAME VALUE]...: runs INPUT with a shortcut and, by the words in
# quotes, without it, and compares how the two end: the work of the gas may differ by WORK, the mean speed of throw by SPEED (shares).
# Scope: a shortcut that saves steps takes at most STEPS (a share) of those without it; 0: it saves none. The two must differ, or it did not act.
set -euo pipefail
program=$1 work=$3 speed=$4 share=$5 input=$6
read -ra off <<<"$2"
shift 6
source "$(dirname "${BASH_SOURCE[0]}")/runs.sh"

mean_throw_speed() {  # of all blocks in the last snapshot, along x
  local snapshots=("$out/$1"/dump/blocks_*.csv)
  check_figures print "${snapshots[-1]}:mean(vx_m_s)"
}

run_input with 2 "$input" "$@"
run_input without 2 "$input" "$@" "${off[@]}"
compare "work of the gas [J]" "$(of_run with gas_work_J)" "$(of_run without gas_work_J)" "$work"
compare "mean speed of throw [m/s]" "$(mean_throw_speed with)" "$(mean_throw_speed without)" "$speed"
[[ $(of_run with gas_work_J) != "$(of_run without gas_work_J)" ]] || { echo "it did not act"; exit 1; }
[[ $share == 0 ]] || check_figures bounds steps "$out/with/dump/run.json:steps" --at-most "$out/without/dump/run.json:steps" --times "$share" ||
  { echo "too few of the steps were saved"; exit 1; }
