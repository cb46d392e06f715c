#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# ranks.sh LIGGGHTS_MUCKPILE "RANKS..." BOUND INPUT [-var NAME VALUE]...: runs INPUT on one rank and on each of RANKS, and compares how they end:
# numbers of blocks must be the same, work of the wave and of the gas and the share of broken joints may differ by BOUND (a share), and
# energy must balance to a hundredth of the blast's work.
# Scope: how the ranks lie is printed; `rank_grid` decides.
set -euo pipefail
program=$1 bound=$3 input=$4
read -ra all_ranks <<<"$2"
shift 4
source "$(dirname "${BASH_SOURCE[0]}")/runs.sh"

run_input 1 1 "$input" "$@"
for ranks in "${all_ranks[@]}"; do
  run_input "$ranks" "$ranks" "$input" "$@"
  grep 'MPI processor grid' "$out/$ranks/screen"
  compare "blocks" "$(of_run "$ranks" blocks)" "$(of_run 1 blocks)" 0
  for quantity in wave_work_J gas_work_J joints_broken_fraction; do
    compare "$quantity" "$(of_run "$ranks" $quantity)" "$(of_run 1 $quantity)" "$bound"
  done
  check_figures near energy_balance_error "$out/$ranks/dump/run.json:energy_balance_error" 0 0.01
done
