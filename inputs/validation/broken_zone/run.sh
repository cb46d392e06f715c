#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# run.sh [RESULTS [LIGGGHTS_MUCKPILE MUCKPILE_POST]]: how far one charge breaks endless rock, for three block sizes, two seeds, another hole, another explosive.
# Writes RESULTS/zones.csv and RESULTS/summary.json. RESULTS is results/broken_zone unless given.
# Scope: fails if a figure is missing or outside what expected.json allows.
set -euo pipefail
# shellcheck source=tests/support/validation_case.sh
source "$(dirname "${BASH_SOURCE[0]}")/../../../tests/support/validation_case.sh" broken_zone "$@"
table=$results/zones.csv
figures=()
echo "run,half_radius_m,tenth_radius_m,half_hole_radii,tenth_hole_radii,crack_half_hole_radii,crack_tenth_hole_radii,crack_beyond_50_radii" >"$table"

# zone NAME [VAR VALUE]...: a row of the table, and five figures of the summary.
zone() {
  local name=$1 out=$results/$1 row half tenth crack_half crack_tenth beyond
  run_input "$case_dir/in.broken_zone" "$out" "${@:2}"
  "$post" damage "$out"
  row=$(check_figures print "$out"/summary.json:{damage_{half_radius_m,tenth_radius_m,half_hole_radii,tenth_hole_radii},crack_{reach_{half,tenth}_hole_radii,directions_beyond_50_radii}})
  echo "$name,${row// /,}" | tee -a "$table"
  read -r _ _ half tenth crack_half crack_tenth beyond <<<"$row"
  figures+=("\"${name}_half_hole_radii\": $half" "\"${name}_tenth_hole_radii\": $tenth" "\"${name}_crack_half_hole_radii\": $crack_half"
    "\"${name}_crack_tenth_hole_radii\": $crack_tenth" "\"${name}_crack_beyond_50_radii\": $beyond")
}

zone standard
zone standard_seed_2 seed 2
zone fine fragment_x50 0.2 block_min 0.14 block_max 0.3
zone coarse fragment_x50 0.4 block_min 0.3 block_max 0.8
zone hole_89_mm hole_diameter 0.089
zone emulsion explosive emulsion
(IFS=,; echo "{${figures[*]}}") >"$results/summary.json"
check_figures case "$case_dir/expected.json" "$results/summary.json"
