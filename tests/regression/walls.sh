#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# walls.sh LIGGGHTS_MUCKPILE BOUND INPUT [-var NAME VALUE]...: INPUT with walls of fix muckpile/wall and with LIGGGHTS' takes to the same rock, and
# what the walls took of it until the end stands in both energy accounts; it may differ by BOUND (a share).
# Scope: until rock has hit the ground; how piles compare is in docs/verification/styles.md.
set -euo pipefail
program=$1 bound=$2 input=$3
shift 3
source "$(dirname "${BASH_SOURCE[0]}")/runs.sh"

wrong=0
for walls in own liggghts; do
  run_input $walls 2 "$input" -var walls $walls "$@"
  check_figures near "$walls: energy balance error" "$out/$walls/dump/run.json:energy_balance_error" 0 0.01 || wrong=1
  check_figures near "$walls: blocks in the solid" "$out/$walls/dump/run.json:blocks_in_solid" 0 0 || wrong=1
  check_figures bounds "$walls: taken by the walls [J]" "$out/$walls/dump/history.csv:wall_J" --at-least 1 || wrong=1
done
grep -q "^fix muckpile/wall 'bottom'" "$out/own/screen" || { echo "no fix muckpile/wall"; wrong=1; }
! grep -q "^fix muckpile/wall" "$out/liggghts/screen" || { echo "fix muckpile/wall with -var walls liggghts"; wrong=1; }
taken() { check_figures print "$out/$1/dump/history.csv:wall_J"; }
compare "taken by the walls [J]" "$(taken own)" "$(taken liggghts)" "$bound" || wrong=1
exit $wrong
