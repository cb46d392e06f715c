#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# zone_files.sh LIGGGHTS_MUCKPILE: the lens of ore of inputs/quarry as a closed surface and as a block model, with the fault through it, makes the
# same blocks, zones included, on 1 and 2 ranks; the ore's blocks have the volume of the lens, and a joint law of the fault and rock of the
# zone are taken.
# Scope: a cut, and a few steps; which block is of which zone is in the unit tests.
set -euo pipefail
program=$1
source "$(dirname "${BASH_SOURCE[0]}")/runs.sh"
source "$(dirname "${BASH_SOURCE[0]}")/cuts.sh"

cut_input "-13 1 -11 11 -5 13" <<'END'
region rock block -10 0 -8 8 -1 10 units box
create_blocks rock density 2700 size uniform 1 block_min 1 block_max 1 spheres_per_block 1 sweeps 5 ${zones} fault inputs/quarry/fault.stl 1 file ${out}/${name}.vtk
fix joint all muckpile/joint youngs_modulus 55e9 poisson_ratio 0.25 density 2700 cohesion 10e6 friction_angle 50 tension 8e6 &
  joint_class 1 law coulomb friction_angle 30 zone ore density 3400 youngs_modulus 40e9 tension 6e6
run 3
END
declare -A zones=([inside]="zone ore 3400 inside inputs/quarry/ore.stl"
  [model]="zone ore 3400 model block_model inputs/quarry/block_model.csv")
for kind in inside model; do same_on_ranks "$kind" "1 2" -var zones "${zones[$kind]}"; done
grep 'block_model .* cells reach' "$out/model1.screen" || fail "no line about the block model"
grep 'fault .*plane: the cut follows it' "$out/inside1.screen" || fail "no line about the fault"
grep "zone 'ore': inside" "$out/inside1.screen" || fail "no line about the surface"
sed -nE "s/.* around ([0-9.]+) m3 .*have ([0-9.]+) m3/{\"lens\": \1, \"blocks\": \2}/p" "$out/inside1.screen" >"$out/inside.json"
awk '/^SCALARS mass_kg/ { on = 1 } /^SCALARS zone/ { on = 2 } /^(SCALARS|LOOKUP)/ { next } on == 1 { mass[n++] = $1 } on == 2 { ore += $1 == 1 ? mass[k] : 0; k++ }
  END { printf "{\"blocks\": %.1f}\n", ore / 3400 }' "$out/model1.vtk" >"$out/model.json"
lens=$(sed -nE 's/.*"lens": ([0-9.]+).*/\1/p' "$out/inside.json")
check_figures near "volume of the ore's blocks, closed surface [m3]" "$out/inside.json:blocks" "$lens" 5
cells=$(awk -F, '$7 == "ore" { sum += $4 * $5 * $6 } END { print sum }' inputs/quarry/block_model.csv)
check_figures near "volume of the ore's blocks, block model [m3]" "$out/model.json:blocks" "$cells" 6
