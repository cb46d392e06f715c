#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# surface_ranks.sh LIGGGHTS_MUCKPILE: rock below a rough terrain in mine coordinates and within a closed body, around one charge, is cut into
# the same blocks on 1, 2 and 4 ranks, and by joint sets on 1 and 2; the report names volume and distance from the surfaces, and both are as good as create_blocks promises.
# Scope: no run; the cut itself is in the unit tests.
set -euo pipefail
program=$1
source "$(dirname "${BASH_SOURCE[0]}")/runs.sh"
source "$(dirname "${BASH_SOURCE[0]}")/cuts.sh"

# East 5000, north 7000 and height 100 are 0 0 0; x looks to the south, y to the east.
awk 'BEGIN { print "east,north,elevation"
  for (i = -12; i <= 12; i++) for (j = -12; j <= 12; j++) { x = i / 4; y = j / 4
    printf "%.3f,%.3f,%.4f\n", 5000 + y, 7000 - x, 101 + 0.3 * sin(1.7 * x) * cos(1.3 * y) + 0.1 * sin(4 * x - 3 * y) } }' >"$out/ground.csv"
# A body whose front leans and has a bulge: fans of triangles around the middles of its six sides.
awk 'function corner(k) { return (k % 2 ? 1.6 : -1.6) - (int(k / 4) ? 0.4 : 0) " " (int(k / 2) % 2 ? 1.5 : -1.5) " " (int(k / 4) ? 1.8 : -1.4) }
  function mine(p,  c) { split(p, c, " "); return 5000 + c[2] " " 7000 - c[1] " " 100 + c[3] }
  function facet(a, b, c) { print "facet normal 0 0 0\nouter loop\nvertex " mine(a) "\nvertex " mine(b) "\nvertex " mine(c) "\nendloop\nendfacet" }
  function side(a, b, c, d, middle) { facet(corner(a), corner(b), middle); facet(corner(b), corner(c), middle); facet(corner(c), corner(d), middle); facet(corner(d), corner(a), middle) }
  BEGIN { print "solid body"
    side(0, 4, 6, 2, "-1.9 0 0.2"); side(1, 3, 7, 5, "1.7 0.1 0.2"); side(0, 1, 5, 4, "-0.2 -1.6 0.2"); side(2, 6, 7, 3, "-0.2 1.6 0.2")
    side(0, 2, 3, 1, "0 0 -1.4"); side(4, 5, 7, 6, "-0.4 0 1.8"); print "endsolid body" }' >"$out/body.stl"

cut_input "-4 4 -4 4 -4 4" <<'END'
region rock block -2 2 -2 2 -1.2 2 units box
create_blocks rock density 2700 size power 0.8 1 block_min 0.25 block_max 0.45 hole 0 0 -0.8 0 0 0.3 0.15 spheres_per_block 1 &
  surface ${out}/body.stl terrain ${out}/ground.csv origin 5000 7000 100 x_bearing 180 file ${out}/${name}.vtk ${cut}
END
same_on_ranks surfaces "1 2 4" -var cut "cut voronoi"
same_on_ranks joint_sets "1 2" -var cut "cut joint_sets joint_set 75 80 joint_set 85 350 joint_set 10 265"
grep 'rock within' "$out/surfaces1.screen" || fail "no line about the surfaces"
grep 'place 0 0 0 is 5000 7000 100' "$out/surfaces1.screen" || fail "the place of the mine is not told"
declare -A least=([surfaces]=99 [joint_sets]=98)
for kind in surfaces joint_sets; do
  figures=$(sed -nE 's/.*crushed zones [0-9.e+]+ m3 \(([-+0-9.e]+) %.*mean, ([0-9.e-]+) at most, ([0-9.e+]+) % .*/{"volume": \1, "farthest": \2, "near": \3}/p' "$out/${kind}1.screen")
  tr -d '+' <<<"$figures" >"$out/$kind.json"
  check_figures near "$kind: volume of the cut over that of the rock [%]" "$out/$kind.json:volume" 0 1
  check_figures bounds "$kind: area within a quarter block [%]" "$out/$kind.json:near" --at-least "${least[$kind]}"
done
