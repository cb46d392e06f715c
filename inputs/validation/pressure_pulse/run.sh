#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# run.sh [RESULTS [LIGGGHTS_MUCKPILE MUCKPILE_POST]]: pieces that pulses of several pressures and rise times break a slab into.
# Writes RESULTS/pieces.csv and RESULTS/summary.json. RESULTS is results/pressure_pulse unless given. SEED=2 takes another cut; 1 is the default.
# Scope: fails if a figure is missing or outside what expected.json allows.
set -euo pipefail
# shellcheck source=tests/support/validation_case.sh
source "$(dirname "${BASH_SOURCE[0]}")/../../../tests/support/validation_case.sh" pressure_pulse "$@"
table=$results/pieces.csv
figures=()
echo "peak_pressure_Pa,rise_time_s,joints,joints_broken,pieces" >"$table"

# pulse NAME PEAK RISE: a row of the table, and two figures of the summary. Pieces are those of 1 % of the slab at least.
pulse() {
  local name=$1 out=$results/$1 row joints broken pieces
  run_input "$case_dir/in.pressure_pulse" "$out" peak_pressure "$2" rise_time "$3" seed "${SEED:-1}"
  "$post" fragments "$out" >/dev/null
  "$post" damage "$out" >/dev/null
  read -r joints broken <<<"$(check_figures print "$out"/dump/history.csv:{joints,joints_broken})"
  pieces=$(check_figures count "$out/fragments_list.csv" volume_m3 6.25e-5)
  echo "$2,$3,$joints,$broken,$pieces" | tee -a "$table"
  figures+=("\"${name}_joints_broken\": $broken" "\"${name}_pieces\": $pieces")
}

# Pressures over the strength of the bonds of that study, 1 MPa; rise times over 0.3 ms, in which a wave crosses the slab.
pulse p075_t2 0.75e6 6e-4
pulse p100_t2 1.0e6 6e-4
pulse p125_t2 1.25e6 6e-4
pulse p150_t2 1.5e6 6e-4
pulse p200_t2 2.0e6 6e-4
pulse p150_t01 1.5e6 3e-5
pulse p200_t01 2.0e6 3e-5
(IFS=,; echo "{${figures[*]}}") >"$results/summary.json"
check_figures case "$case_dir/expected.json" "$results/summary.json"
