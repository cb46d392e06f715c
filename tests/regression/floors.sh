#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# floors.sh LIGGGHTS_MUCKPILE: LIGGGHTS takes the floor of inputs/common/pit_floor.in for benches of any shape: narrow and long, a wide row, a deep
# step. Its panels cover floor and step once, and none is more than 8 times as long as wide. Rock beyond the floor is warned about.
set -euo pipefail
program=$1
source "$(dirname "${BASH_SOURCE[0]}")/../support/script.sh"
source "$root/tests/support/check_figures.sh"
mkdir "$out/dump"

cat >"$out/in.floor" <<'END'
units si
atom_style granular
atom_modify map array sort 0 0
boundary f f f
newton off
communicate single vel yes
region box block -1 2001 -200 200 -50 50 units box
create_box 1 box
neighbor 0.1 bin
neigh_modify binsize 20
include inputs/common/pit_floor.in
fix floor all mesh/surface file ${out}/dump/floor.stl type 1
run 0
# Of five places four are where no rock can be: under the floor, below the bottom, behind the rear, behind the step.
create_atoms 1 single 10 0 -1
create_atoms 1 single -0.5 0 -40.6
create_atoms 1 single -0.9 0 5
create_atoms 1 single 0.6 0 -20
create_atoms 1 single 0 0 -20
variable inside equal count(all,in_the_ground)
print "in the ground: ${inside}"
# One more is beyond the floor's end, and the first one, too, where the floor is short.
variable end equal ${floor_length}+0.5
create_atoms 1 single ${end} 0 1
variable beyond equal count(all)-count(all,on_the_floor)-(${floor_length}<10)
print "beyond the end: ${beyond}"
END

wrong=0
floor() {  # floor LENGTH HALF_WIDTH DEPTH: from x = 0.05 m on
  rm -f "$out/dump/floor.stl"
  "$program" -in "$out/in.floor" -log none -var out "$out" -var floor_start 0.05 -var floor_length "$1" -var floor_half_width "$2" \
    -var floor_depth "$3" -var block_max 1 \
    -var bottom_z -40 -var rear_x -0.3 >"$out/screen" 2>&1 </dev/null || { echo "$*: refused: $(grep ERROR "$out/screen")"; wrong=1; return; }
  grep -q "^in the ground: 4$" "$out/screen" || { echo "$*: of five places four are in the ground, got '$(grep "^in the ground" "$out/screen")'"; wrong=1; }
  grep -q "^beyond the end: 1$" "$out/screen" || { echo "$*: one place is beyond the end, got '$(grep "^beyond" "$out/screen")'"; wrong=1; }
  awk '
    $1 == "vertex" { n++; x[n] = $2; y[n] = $3; z[n] = $4 }
    function side(a, b) { return sqrt((x[a]-x[b])^2 + (y[a]-y[b])^2 + (z[a]-z[b])^2) }
    $1 == "endfacet" {
      a = side(1, 2); b = side(2, 3); c = side(3, 1)
      diagonal = a > b ? a : b; if (c > diagonal) diagonal = c
      least = a < b ? a : b; if (c < least) least = c
      area += a * b * c / diagonal / 2
      long = (a + b + c - diagonal - least) / least
      if (long > longest) longest = long
      n = 0
    }
    END { printf "{\"area_m2\": %.9g, \"length_by_width\": %.9g}\n", area, longest }' "$out/dump/floor.stl" >"$out/floor.json"
  local expected
  expected=$(awk -v l="$1" -v w="$2" -v d="$3" 'BEGIN { printf "%.9g", 2 * w * (l - 0.05 + d) }')
  check_figures near "$*: area [m2]" "$out/floor.json:area_m2" "$expected" 1e-5 --share || wrong=1
  check_figures bounds "$*: longest panel by its width" "$out/floor.json:length_by_width" --at-least 1 --at-most 8.001 || wrong=1
}

cd "$root"
floor 200 2.775 2.4    # in.bench
floor 1000 2.15 1.6    # -var bench_height 50 -var burden 2
floor 2000 0.915 0.04  # bench_height 100, holes 0.03 m apart, burden 0.05 m
floor 2 32 40          # bench_height 0.1, burden 50
floor 200 188.4 2.4    # -var holes 100
floor 300 160 4        # in.pattern

# Of eight blocks of 0.5 m four are beyond the end of the scene.
cat >"$out/in.beyond" <<'END'
units si
atom_style granular
atom_modify map array
newton off
boundary f f f
communicate single vel yes
region box block -2 2 -2 2 -2 2 units box
create_box 1 box
neighbor 0.01 bin
timestep 1e-6
pair_style muckpile/block
pair_coeff * *
fix bodies all multisphere
region rock block 0 1 0 1 0 1 units box
region on_the_floor block INF 0.5 INF INF INF INF units box
create_blocks rock density 2000 size uniform 0.5 block_min 0.5 block_max 0.5 cut joint_sets joint_set 90 0 joint_set 90 90 spheres_per_block 1
fix energy all muckpile/ledger
fix progress all muckpile/progress every 1 directory ${out} scene on_the_floor
run 2
END
"$program" -in "$out/in.beyond" -log none -var out "$out" >"$out/screen" 2>&1 </dev/null || { echo "blocks beyond the end: $(grep ERROR "$out/screen")"; wrong=1; }
[[ $(grep -c "rock has left the scene, region 'on_the_floor': 4 blocks of 1000 kg at t = " "$out/screen") == 1 ]] ||
  { echo "no warning, or several, of rock beyond the floor"; wrong=1; }
exit $wrong
