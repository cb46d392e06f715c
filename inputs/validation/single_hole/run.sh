#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# run.sh [RESULTS [LIGGGHTS_MUCKPILE MUCKPILE_POST]]: a single hole in benches as high as their burden, 0.5 to 8 m, with more and more charge.
# Writes RESULTS/charges.csv and RESULTS/summary.json. RESULTS is results/single_hole unless given. SEEDS="1" takes one cut; three are the default.
# Scope: fails if a figure is missing or outside what expected.json allows.
set -euo pipefail
# shellcheck source=tests/support/validation_case.sh
source "$(dirname "${BASH_SOURCE[0]}")/../../../tests/support/validation_case.sh" single_hole "$@"
table=$results/charges.csv
echo "burden_m,hole_diameter_m,seed,charge_kg,throw_m,moved_volume_m3" >"$table"

# bench BURDEN SUBDRILL STEMMING STANDING SPACING RISE X50 BLOCK_MIN BLOCK_MAX DIAMETER...: a row of the table per diameter and seed. The charge
# reaches from 0.3 burdens below the floor to 0.3 above it.
bench() {
  local diameter seed out figures
  for diameter in "${@:10}"; do
    for seed in ${SEEDS:-1 2 3}; do
      out=$results/w$1_d${diameter}_s$seed
      run_input inputs/quarry/in.quarry "$out" rows 1 holes_per_row 1 face_angle 90 hole_angle 90 explosive gelatine burden "$1" bench_height "$1" \
        subdrill "$2" stemming "$3" standing "$4" spacing "$5" rise_time "$6" fragment_x50 "$7" block_min "$8" block_max "$9" \
        hole_diameter "$diameter" seed "$seed"
      "$post" rows "$out" >/dev/null
      figures=$(check_figures print "$out"/rows.csv:{charge_kg,throw_m,moved_volume_m3})
      echo "$1,$diameter,$seed,${figures// /,}" | tee -a "$table"
    done
  done
}
bench 0.5 0.15 0.35 1.5 0.625 2e-5 0.08 0.036 0.1 0.0121 0.0139 0.0157 0.0194
bench 2 0.6 1.4 6 2.5 8e-5 0.32 0.144 0.4 0.0371 0.0424 0.0484 0.0629 0.0774
bench 8 2.4 5.6 24 10 3.2e-4 1.28 0.576 1.6 0.121 0.1483 0.194 0.2517
check_figures limit_charges "$table" "$results/summary.json"
check_figures case "$case_dir/expected.json" "$results/summary.json"
