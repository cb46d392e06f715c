#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# run.sh [RESULTS [LIGGGHTS_MUCKPILE MUCKPILE_POST]]: craters of 20 kg at eight depths beside Boreskov's and Pokrovskii's rules.
# Writes RESULTS/craters.csv and RESULTS/summary.json. RESULTS is results/crater_depth unless given. SEEDS="1 2 3" takes three seeds; one is the default.
# SYMMETRY=1 models the whole crater; a quarter (4) is the default.
# Scope: fails if a figure is missing or outside what expected.json allows.
set -euo pipefail
# shellcheck source=tests/support/validation_case.sh
source "$(dirname "${BASH_SOURCE[0]}")/../../../tests/support/validation_case.sh" crater_depth "$@"
table=$results/craters.csv
echo "scaled_depth_m_kg13,seed,charge_mass_kg,burial_depth_m,crater_radius_m,crater_depth_m,crater_volume_m3,gas_work_J,joints_broken_fraction,apparent_crater_radius_m,apparent_crater_depth_m,apparent_crater_volume_m3,ejecta_mass_kg" >"$table"

# Depths in m are scaled ones times the cube root of 20 kg; blocks are of one size law, 0.30 m at 1.43 m from the charge, and of one
# fracture energy, whatever the depth. Blocks of shallow charges fly for 20 s and more: there the run ends once all has broken out, without a visible crater.
# crater SCALED DEPTH X50 FINEST END: a row of the table per seed.
crater() {
  local seed out figures visible
  for seed in ${SEEDS:-1}; do
    out=$results/d$1_s$seed
    run_input inputs/crater/in.crater "$out" symmetry "${SYMMETRY:-4}" burial_depth "$2" fragment_x50 "$3" finest_fragment "$4" time_end "$5" block_min 0.22 block_max 1.2 sphere_gap 0 seed "$seed"
    "$post" crater "$out" >/dev/null
    figures=$(check_figures print "$out"/summary.json:{crater_radius_m,crater_depth_m,crater_volume_m3,gas_work_J,joints_broken_fraction})
    visible=,,,
    if grep -q '"still": true' "$out/summary.json"; then
      visible=$(check_figures print "$out"/summary.json:{apparent_crater_radius_m,apparent_crater_depth_m,apparent_crater_volume_m3,ejecta_mass_kg})
    fi
    echo "$1,$seed,20,$2,${figures// /,},${visible// /,}" | tee -a "$table"
  done
}
crater 0.25 0.679 0.1132 0.3773e-4 1.5
crater 0.4 1.086 0.1810 0.6033e-4 1.5
crater 0.55 1.493 0.2488 0.8293e-4 20
crater 0.7 1.900 0.3167 1.056e-4 20
crater 0.9 2.443 0.4072 1.357e-4 20
crater 1.2 3.257 0.5428 1.809e-4 20
crater 1.6 4.343 0.7238 2.413e-4 20
crater 2.0 5.429 0.9048 3.016e-4 20
check_figures crater_depths "$table" "$results/summary.json"
check_figures case "$case_dir/expected.json" "$results/summary.json"
