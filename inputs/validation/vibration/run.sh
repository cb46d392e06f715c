#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# run.sh [RESULTS [LIGGGHTS_MUCKPILE MUCKPILE_POST]]: peak particle velocity behind a bench that one hole of ANFO blasts, on top and at half the charge's
# height, in two cuts, beside the laws of Holmberg and Persson and of the U.S. Bureau of Mines.
# Writes RESULTS/summary.json. RESULTS is results/vibration unless given.
# Scope: fails if a figure is missing or outside what expected.json allows.
set -euo pipefail
# shellcheck source=tests/support/validation_case.sh
source "$(dirname "${BASH_SOURCE[0]}")/../../../tests/support/validation_case.sh" vibration "$@"

for seed in 1 2; do
  out=$results/seed_$seed
  run_input inputs/quarry/in.quarry "$out" rows 1 holes_per_row 1 face_angle 90 hole_angle 90 standing 20 time_end 0.03 seed "$seed" \
    gauge_interval 2e-5 gauge_line 0 gauge_words "line -3.5 0 4.5 -21.5 0 4.5 25 line -3.5 0 9.9 -21.5 0 9.9 25"
  "$post" waves "$out" --until 0.02
done
check_figures hole_vibration "$results/summary.json" "$results"/seed_{1,2} --distances 2 6 19
check_figures case "$case_dir/expected.json" "$results/summary.json" "$results/seed_1/summary.json"
