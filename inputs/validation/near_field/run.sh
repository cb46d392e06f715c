#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# run.sh [RESULTS [LIGGGHTS_MUCKPILE MUCKPILE_POST]]: peak particle velocity beside one charge, by in.broken_zone with gauges, for holes of 51 to 204 mm, three
# block sizes, two seeds, other explosives and another rock, beside the law of Holmberg and Persson; then in blocks of one size, with joints that break and
# joints that hold, beside the exact wave.
# Writes RESULTS/summary.json. RESULTS is results/near_field unless given.
# Scope: fails if a figure is missing or outside what expected.json allows.
set -euo pipefail
# shellcheck source=tests/support/validation_case.sh
source "$(dirname "${BASH_SOURCE[0]}")/../../../tests/support/validation_case.sh" near_field "$@"
# Along x, along y, and between them.
lines="line 0.6 0 0.5 7.4 0 0.5 25 line 0 0.6 0.5 0 7.4 0.5 25 line 0.43 0.43 0.5 5.23 5.23 0.5 25"
folders=()

# peaks NAME [VAR VALUE]...: a run, and its peak velocities at the gauges.
peaks() {
  local name=$1 out=$results/$1
  run_input inputs/validation/broken_zone/in.broken_zone "$out" "${@:2}" gauge_interval 1e-5 gauge_line 0 gauge_words "$lines" \
    half_width 8 thickness 1 time_end 4e-3  # of values given twice the first holds
  "$post" waves "$out" --until 3e-3
  folders+=("$out")
}

peaks anfo
peaks seed_2 seed 2
peaks fine fragment_x50 0.2 block_min 0.14 block_max 0.3
peaks coarse fragment_x50 0.4 block_min 0.3 block_max 0.8
peaks hole_51_mm hole_diameter 0.051
peaks hole_72_mm hole_diameter 0.072
peaks hole_144_mm hole_diameter 0.144
peaks hole_204_mm hole_diameter 0.204
# The velocity of detonation in thin holes over the table's, squared.
peaks share_51_mm hole_diameter 0.051 energy_share 0.49
peaks share_102_mm energy_share 0.755
peaks share_204_mm hole_diameter 0.204 energy_share 0.965
peaks heavy_anfo explosive heavy_anfo
peaks emulsion explosive emulsion
peaks anfo_shock attenuation shock
peaks emulsion_shock explosive emulsion attenuation shock
peaks anfo_two_stage expansion two_stage attenuation shock
peaks emulsion_two_stage explosive emulsion expansion two_stage attenuation shock
# Liu and Katsabanis' exponents of the two.
peaks anfo_own_fall attenuation_exponent 1.43
peaks emulsion_own_fall explosive emulsion attenuation_exponent 1.49
peaks limestone rock limestone
check_figures near_field "$results/summary.json" 2 7.4 "${folders[@]}"

# one_size SIZE HALF_WIDTH THICKNESS: blocks of one size, once as they are and once with a thousand times the strength, which no joint reaches.
one_size() {
  local middle lines  # peaks takes these
  middle=$(awk -v t="$3" 'BEGIN { print t / 2 }')
  lines="line 2 0 $middle 3.4 0 $middle 15 line 0 2 $middle 0 3.4 $middle 15 line 1.42 1.42 $middle 2.4 2.4 $middle 15"
  local same=(fragment_x50 "$1" block_min "$1" block_max "$1" size_exponent 0.01 half_width "$2" thickness "$3" time_end 3e-3)
  peaks "breaks_$1" "${same[@]}"
  peaks "holds_$1" "${same[@]}" tensile_strength 1e10 cohesion 3.1e10
}
folders=()
one_size 0.2 6 0.6
one_size 0.14 5 0.42
one_size 0.1 4 0.3
# The pulse on the crushed zone as fix muckpile/blast tells it, and its radius; granite.
check_figures near_field "$results/one_size.json" 2 3.4 "${folders[@]}" --pulse 535.5e6 1e-4 0.1058 --rock 2650 55e9 0.25
check_figures case "$case_dir/expected.json" "$results/summary.json" "$results/one_size.json"
