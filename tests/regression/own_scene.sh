#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# own_scene.sh LIGGGHTS_MUCKPILE: the small scene of inputs/own_scene, whose last six lines are a whole blast, goes through its phases and comes
# to rest on two ranks; and those six lines are the example of docs/styles/run_blast.md.
set -euo pipefail
program=$1
source "$(dirname "${BASH_SOURCE[0]}")/runs.sh"

wrong=0
while IFS= read -r line; do
  grep -qxF -- "$line" docs/styles/run_blast.md || { echo "not in docs/styles/run_blast.md: $line"; wrong=1; }
done < <(tail -n 6 inputs/own_scene/in.own_scene)

run_input run 2 inputs/own_scene/in.own_scene
readonly dump=$out/run/dump
for phase in wave_and_gas throw; do
  grep -q ",$phase," "$dump/history.csv" || { echo "no phase $phase in history.csv"; wrong=1; }
done
grep -q '^The rock rests after' "$out/run/screen" || { echo "the rock does not rest"; wrong=1; }
check_figures bounds "time [s]" "$dump/run.json:physical_time_s" --at-most 5.9 || wrong=1
check_figures bounds "broken share of the joints" "$dump/run.json:joints_broken_fraction" --at-least 0.8 || wrong=1
check_figures near "energy balance error" "$dump/run.json:energy_balance_error" 0 0.02 || wrong=1
check_figures near "blocks in the solid" "$dump/run.json:blocks_in_solid" 0 0 || wrong=1
exit $wrong
