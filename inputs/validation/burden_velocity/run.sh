#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# run.sh [RESULTS [LIGGGHTS_MUCKPILE MUCKPILE_POST]]: runs in.burden_velocity for burdens of 2.5 to 4 m and three seeds, fits v = c W^-n to the face velocities,
# and writes RESULTS/velocities.csv and RESULTS/summary.json. RESULTS is results/burden_velocity unless given.
# Scope: takes the programs of build/release unless others are named; fails if a figure is missing or outside what expected.json allows.
set -euo pipefail
root=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../../..")
case_dir=inputs/validation/burden_velocity
cd "$root"
results=${1:-results/burden_velocity}
program=${2:-build/release/src/app/liggghts-muckpile} post=${3:-build/release/postproc/tools/muckpile-post}
source tests/support/check_figures.sh
mkdir -p "$results"
table=$results/velocities.csv
echo "burden_m,seed,face_velocity_m_s,wave_work_J,gas_work_J,explosive_energy_J" >"$table"

for burden in 2.5 3 3.5 4; do
  for seed in 1 2 3; do
    out=$results/w${burden}_s$seed
    rm -rf "$out" && mkdir -p "$out/dump"
    OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_btl_vader_single_copy_mechanism=none \
      mpirun -np 1 --bind-to none "$program" -in $case_dir/in.burden_velocity -log none \
      -var out "$out" -var burden "$burden" -var seed "$seed" >"$out/screen"
    "$post" profile "$out"
    summary=$out/summary.json
    figures=$(check_figures print "$summary:face_velocity_mean_m_s" "$summary:wave_work_J" "$summary:gas_work_J" "$summary:explosive_energy_J")
    echo "$burden,$seed,${figures// /,}" | tee -a "$table"
  done
done

check_figures burden_fit "$table" "$results/summary.json"
check_figures case $case_dir/expected.json "$results/summary.json"
