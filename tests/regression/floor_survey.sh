#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# floor_survey.sh LIGGGHTS_MUCKPILE: blocks that fall on a surveyed floor come to rest at the height of the survey: on its slope where that is lower
# than the base of the rock, on the level above its step, and beside the place of the rock, where the floor in front begins; at that place they rest
# at the base of the rock. The quarry has such a floor, and refuses it with walls that cannot follow it.
# Scope: four cubes of one sphere each, whose centres rest a radius from the ground.
set -euo pipefail
program=$1
source "$(dirname "${BASH_SOURCE[0]}")/runs.sh"

# Falls by 10 % along x and rises by 4 % along y, from 1 m below the toe up to a level of 0.5 m between x = 10 and 11.
awk 'BEGIN { for (x = -5; x <= 30; x += 1) for (y = -15; y <= 15; y += 1)
  print 5000 + x "," 7000 + y "," 200 + (x > 10 ? 0.5 : -0.1 * x + 0.04 * y) }' >"$out/ground.csv"
wrong=0
rests() {  # rests NAME X Y Z COSINE HEIGHT: dropped from Z, its spheres' centres rest above HEIGHT(x, y), an awk expression
  run_input "$1" 1 tests/regression/in.fall -var with_floor_file 1 -var floor_file "${ground:-$out/ground.csv}" -var x "$2" -var y "$3" -var z "$4"
  local last
  last=$(ls -v "$out/$1"/dump/blocks_*.csv | tail -n 1)
  # The elastic overlap of 340 kg is 4 mm.
  awk -F, -v cosine="$5" '
    /^#/ { next }
    !n++ { for (k = 1; k <= NF; ++k) { if ($k == "x_m") cx = k; if ($k == "y_m") cy = k; if ($k == "z_m") cz = k }; next }
    { x = $cx; y = $cy; off = $cz - ('"$6"') - 0.25 / cosine; blocks++; if (off < -0.008 || off > 0.002) bad++; printf "x %.3f y %.3f z %.4f off %.4f m\n", x, y, $cz, off }
    END { exit !(blocks == 4 && bad == 0) }' "$last" || { echo "$1: does not rest at the height of the survey"; wrong=1; }
  check_figures near "$1: blocks in the ground" "$out/$1/dump/run.json:blocks_in_solid" 0 0 || wrong=1
}
rests slope 5 0 0.2 0.99425 "-0.1 * x + 0.04 * y"  # cosine 1 / sqrt(1 + 0.1^2 + 0.04^2)
rests level 14 0 0.8 1 "0.5"
rests beside 0 6 0.8 0.99425 "-0.1 * x + 0.04 * y"
rests under_the_rock -3 0 0.2 1 "-0.3"
# A survey that begins 3 m in front of the block, 7.5 m in front of the rock: there its edge goes on, and that is told.
awk -F, '$1 >= 5008' "$out/ground.csv" >"$out/begins.csv"
ground=$out/begins.csv rests edge 5 0 0.2 0.99920 "-0.8 + 0.04 * y"
grep -q "WARNING: the survey begins at x = 8 m, the floor at x = 0.5 m" "$out/edge/screen" || { echo "not told where the survey begins"; wrong=1; }
grep -qE '^lowest -1.(6|59999+[0-9]*) highest 1.(1|09999+[0-9]*|10000+[0-9]*)$' "$out/level/screen" || { echo "not the survey's heights: $(grep ^lowest "$out/level/screen")"; wrong=1; }

# The quarry: the same floor in front of its plane face, cut at the end of the rock.
run_quarry() {  # run_quarry [-var NAME VALUE]...: of two values of a knob the first counts
  sed '/^run_blast/,$c run 0' inputs/quarry/in.quarry >"$out/in.quarry"
  rm -rf "$out/quarry" && mkdir -p "$out/quarry/dump"
  on_ranks 1 -in "$out/in.quarry" -log none -var out "$out/quarry" "$@" -var rows 1 -var holes_per_row 2 -var block_min 0.7 -var block_max 1.6 \
    -var fragment_x50 1.1 -var rise_time 4e-4 -var crushed_ratio 8 -var crushed_grain 7.875e-3 -var floor_survey "$out/ground.csv" \
    -var terrain_east 5000 -var terrain_north 7000 -var terrain_height 200 >"$out/quarry/screen" 2>&1
}
run_quarry || { tail -n 5 "$out/quarry/screen"; wrong=1; }
grep -q "ground of $out/ground.csv from x = .* between z = -1.55[0-9]* and 1.1 m, in panels of 0.8 m" "$out/quarry/screen" || { grep "ground of" "$out/quarry/screen"; echo "the quarry has not the floor of the survey"; wrong=1; }
grep -q '"floor_survey": 1' "$out/quarry/dump/scene.json" || { echo "scene.json does not tell of the floor"; wrong=1; }
! grep -q "WARNING: in front of the rock" "$out/quarry/screen" || { echo "a floor at the toe is warned of"; wrong=1; }
if run_quarry -var walls liggghts; then echo "walls liggghts are not refused"; wrong=1; fi
grep -q "walls_on_the_floor_of_floor_survey must be one of own, got 'liggghts'" "$out/quarry/screen" || { grep ERROR "$out/quarry/screen"; wrong=1; }

run_quarry -var terrain_height 197 || wrong=1
grep -qE "WARNING: in front of the rock the surveyed floor is 2.9[0-9]* m above the toe" "$out/quarry/screen" || { echo "a floor above the toe is not warned of"; wrong=1; }

# The survey of the quarry in metres, and in millimetres at another place: rock and floor are the same, and without the unit it is refused.
awk -F, '/^[-0-9]/ { printf "%.0f,%.0f,%.0f\n", 1e3 * ($1 + 5000), 1e3 * ($2 + 7000), 1e3 * ($3 + 200); next } { print }' inputs/quarry/survey.csv >"$out/mm.csv"
told() { sed -nE 's/^write_panels: ground of [^ ]* (from .*)/\1/p; s/^  (rock within .* m3) \(.*/\1/p' "$out/quarry/screen"; }
run_quarry -var terrain inputs/quarry/survey.csv -var floor_survey inputs/quarry/survey.csv -var terrain_east 0 -var terrain_north 0 -var terrain_height 0 || wrong=1
metres=$(told)
run_quarry -var terrain "$out/mm.csv" -var floor_survey "$out/mm.csv" -var terrain_unit 0.001 || wrong=1
[[ $(wc -l <<<"$metres") -eq 2 && $(told) == "$metres" ]] || { echo "a survey in millimetres gives other ground: $(told), in metres $metres"; wrong=1; }
if run_quarry -var terrain "$out/mm.csv" -var floor_survey "$out/mm.csv"; then echo "millimetres are taken for metres"; wrong=1; fi
grep -q "looks like millimetres: give unit 0.001, or unit 1 if it is in metres (inputs/quarry: -var terrain_unit)" "$out/quarry/screen" || { grep ERROR "$out/quarry/screen"; wrong=1; }
exit $wrong
