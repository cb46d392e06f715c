#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# run.sh [RESULTS [LIGGGHTS_MUCKPILE MUCKPILE_POST]]: runs in.burden_velocity for burdens of 2.5 to 4 m and three seeds, fits v = c W^-n to the face velocities,
# and writes RESULTS/velocities.csv and RESULTS/summary.json. RESULTS is results/burden_velocity unless given.
# Scope: fails if a figure is missing or outside what expected.json allows.
set -euo pipefail
# shellcheck source=tests/support/validation_case.sh
source "$(dirname "${BASH_SOURCE[0]}")/../../../tests/support/validation_case.sh" burden_velocity "$@"
table=$results/velocities.csv
echo "burden_m,seed,face_velocity_m_s,wave_work_J,gas_work_J,explosive_energy_J" >"$table"

for burden in 2.5 3 3.5 4; do
  for seed in 1 2 3; do
    out=$results/w${burden}_s$seed
    run_input "$case_dir/in.burden_velocity" "$out" burden "$burden" seed "$seed"
    "$post" profile "$out"
    summary=$out/summary.json
    figures=$(check_figures print "$summary:face_velocity_mean_m_s" "$summary:wave_work_J" "$summary:gas_work_J" "$summary:explosive_energy_J")
    echo "$burden,$seed,${figures// /,}" | tee -a "$table"
  done
done

check_figures burden_fit "$table" "$results/summary.json"
check_figures case "$case_dir/expected.json" "$results/summary.json"
