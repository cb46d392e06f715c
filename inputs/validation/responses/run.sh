#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# run.sh [RESULTS [LIGGGHTS_MUCKPILE MUCKPILE_POST]]: a small bench blast, and the same with one thing changed at a time; exponents of what it answers.
# Writes RESULTS/answers.csv and RESULTS/summary.json. RESULTS is results/responses unless given.
# Scope: fails if a figure is missing or outside what expected.json allows.
set -euo pipefail
# shellcheck source=tests/support/validation_case.sh
source "$(dirname "${BASH_SOURCE[0]}")/../../../tests/support/validation_case.sh" responses "$@"
table=$results/answers.csv
echo "name,factor,value,base" >"$table"

# blast NAME [VAR VALUE]...: runs the scene until the burden is in flight, prints face velocity [m/s] and work of the gas [J].
blast() {
  local out=$results/$1
  run_input inputs/bench/in.bench "$out" "${@:2}" accuracy quick bench_height 4 burden 1.8 hole_diameter 0.06 time_end 0.1
  "$post" profile "$out" >/dev/null
  check_figures print "$out/summary.json:face_velocity_mean_m_s" "$out/summary.json:gas_work_J"
}

read -r base_speed base_work < <(blast base)
# answer NAME FACTOR speed|work [VAR VALUE]...: a row of the table.
answer() {
  local name=$1 factor=$2 figure=$3 speed work
  shift 3
  read -r speed work < <(blast "${name}_$factor" "$@")
  if [[ $figure == speed ]]; then
    echo "$name,$factor,$speed,$base_speed" | tee -a "$table"
  else
    echo "$name,$factor,$work,$base_work" | tee -a "$table"
  fi
}
answer density 0.5 speed explosive_density 550
answer density 0.75 speed explosive_density 825
answer energy_share 0.5 speed energy_share 0.5
answer charge 0.5 speed hole_diameter 0.0424264
answer blocks 0.8 work block_min 0.188 block_max 0.52 fragment_x50 0.272
answer blocks 1.3 work block_min 0.3055 block_max 0.845 fragment_x50 0.442
check_figures exponents "$table" "$results/summary.json"
check_figures case "$case_dir/expected.json" "$results/summary.json"
