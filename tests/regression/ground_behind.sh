#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# ground_behind.sh LIGGGHTS_MUCKPILE: blocks that fly back over the rock land on the ground behind it, level at rear_top, and rest there; without a
# top they are stopped by the plane. The quarry gives that ground the height of the bench.
# Scope: four cubes of one sphere each, drawn back by half of gravity, whose centres rest a radius from the ground.
set -euo pipefail
program=$1
source "$(dirname "${BASH_SOURCE[0]}")/runs.sh"

wrong=0
flies() {  # flies NAME CONDITION [-var NAME VALUE]...: an awk expression of x and z at rest
  local name=$1 condition=$2
  shift 2
  run_input "$name" 1 tests/regression/in.fall -var x 0 -var y 0 -var z 4 -var rear_x -0.3 -var pull_x -0.5 "$@"
  local last
  last=$(ls -v "$out/$name"/dump/blocks_*.csv | tail -n 1)
  awk -F, '/^#/ || /^id/ { next } { x = $2; z = $4; blocks++; if (!('"$condition"')) { bad++; print "x " x " z " z } }
    END { exit !(blocks == 4 && bad == 0) }' "$last" || { echo "$name: not $condition"; wrong=1; }
  check_figures near "$name: blocks in the ground" "$out/$name/dump/run.json:blocks_in_solid" 0 0 || wrong=1
}
# The elastic overlap of 340 kg is 4 mm, more with the pull.
flies over "x < -0.3 && z > 1.25 - 0.008 && z < 1.252" -var rear_top 1
flies stopped "x > -0.3 + 0.25 - 0.008"

# The lowest and highest corner of a file of triangles.
heights() { awk '$1 == "vertex" { z = $4; if (!n++ || z < low) low = z; if (n == 1 || z > high) high = z } END { printf "%.3f %.3f", low, high }' "$1"; }
top_of() {  # top_of INPUT HEIGHT [-var NAME VALUE]...
  local input=$1 height=$2 name
  shift 2
  name=$(basename "$input")
  sed '/^run_blast/,$c run 0' "$input" >"$out/$name"
  run_input "$name.set_up" 1 "$out/$name" "$@"
  [[ $(heights "$out/$name.set_up/dump/behind.stl") == *" $height" ]] || { echo "$name: ground behind $(heights "$out/$name.set_up/dump/behind.stl")"; wrong=1; }
}
coarse=(-var block_min 0.7 -var block_max 1.6 -var fragment_x50 1.1 -var rise_time 4e-4 -var crushed_ratio 8 -var crushed_grain 7.875e-3)
top_of inputs/quarry/in.quarry 8.000 "${coarse[@]}" -var rows 1 -var holes_per_row 2 -var bench_height 8
top_of inputs/bench/in.bench 4.000 -var accuracy quick -var bench_height 4 -var burden 1.5 -var hole_diameter 0.06
top_of inputs/pattern/in.pattern 10.000 -var hole_table tests/regression/two_holes.csv
exit $wrong
