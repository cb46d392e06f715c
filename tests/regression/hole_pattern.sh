#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# hole_pattern.sh LIGGGHTS_MUCKPILE: the command writes the same table on one and two ranks, which charge_design reads on all of them; a table of
# one's own is taken as it is, and its folder is made; holes of Kirra come from the mine's coordinates into those of the bench, and the quarry
# puts them where its surveyed ground is. A charge thinner than its holes gives them crushed zones of their own in the table.
# Scope: no blast; the numbers of the table are in the unit tests.
set -euo pipefail
program=$1
source "$(dirname "${BASH_SOURCE[0]}")/runs.sh"

cat >"$out/in.table" <<'END'
units si
atom_style granular
hole_pattern file ${table} take ${own} rows 2 holes_per_row 3 burden 2.5 spacing 3 bench_height 10 subdrill 0.75 stemming 2.2 hole_diameter 0.089 &
  face_angle 76 hole_angle 76 delay_in_row 0.017 delay_between_rows 0.042
charge_design explosive anfo crushed_ratio 3 hole_table ${table}
print "holes ${pattern_holes} last ${pattern_last_firing}"
END
for ranks in 1 2; do
  on_ranks "$ranks" -in "$out/in.table" -log none -var own none -var table "$out/new/$ranks.csv" >"$out/screen$ranks"
  grep -q '^holes 6 last 0.076' "$out/screen$ranks" || fail "charge_design has not read the table of $ranks ranks: $(tail -n 3 "$out/screen$ranks")"
done
cmp "$out/new/1.csv" "$out/new/2.csv" || fail "the tables of one and two ranks differ"
[[ $(grep -c '^r[12]h[123],' "$out/new/1.csv") -eq 6 ]] || fail "not six holes"

sed 's/0\.042/0.05/' "$out/new/1.csv" >"$out/own.csv"
on_ranks 2 -in "$out/in.table" -log none -var own "$out/own.csv" -var table "$out/taken/holes.csv" >"$out/screen3"
cmp "$out/own.csv" "$out/taken/holes.csv" || fail "the table of one's own was changed"
grep -q '^holes 6 last 0.084' "$out/screen3" || fail "the table of one's own was not read"
# Stemming is counted from bench_height, whatever the collars of the table.
! grep -q WARNING "$out/screen3" || fail "collars at bench_height are warned of: $(grep WARNING "$out/screen3")"
sed 's/bench_height 10/bench_height 8/' "$out/in.table" >"$out/in.lower"
on_ranks 2 -in "$out/in.lower" -log none -var own "$out/own.csv" -var table "$out/lower.csv" >"$out/screen"
[[ $(grep -c "WARNING: hole_pattern: the collars of $out/own.csv stand at z = 10 m in the mean, but bench_height, .*, is 8 m" "$out/screen") -eq 1 ]] ||
  fail "collars above bench_height are not warned of once"
awk -F, -v OFS=, '$1 == "r1h2" { swap = $4; $4 = $7; $7 = swap } 1' "$out/own.csv" >"$out/up.csv"
on_ranks 1 -in "$out/in.table" -log none -var own "$out/up.csv" -var table "$out/taken/up.csv" >"$out/screen"
[[ $(grep -c "WARNING: hole_pattern: hole r1h2 of $out/up.csv has its toe above its collar" "$out/screen") -eq 1 ]] ||
  fail "a hole upside down is not warned of"

# Scatter: the same on one and two ranks, another by another seed, and read by charge_design.
scattered() { sed "s/^hole_pattern/& scatter $1 scatter_seed $2/" "$out/in.table" >"$out/in.scattered"; }
for ranks in 1 2; do
  scattered 0.05 3
  on_ranks "$ranks" -in "$out/in.scattered" -log none -var own none -var table "$out/scattered$ranks.csv" >"$out/screen"
  ! grep -q '^holes 6 last 0.076$' "$out/screen" || fail "charge_design has not read the scatter"
done
cmp "$out/scattered1.csv" "$out/scattered2.csv" || fail "scatter of one and two ranks differs"
scattered 0.05 4
on_ranks 1 -in "$out/in.scattered" -log none -var own none -var table "$out/scattered4.csv" >"$out/screen"
! cmp -s "$out/scattered1.csv" "$out/scattered4.csv" || fail "another seed gives the same scatter"
grep -q 'delays scatter by 5 % of each, seed 4: ' "$out/screen" || fail "no line about the scatter"
scattered 0 4
on_ranks 1 -in "$out/in.scattered" -log none -var own none -var table "$out/scattered0.csv" >"$out/screen"
cmp "$out/new/1.csv" "$out/scattered0.csv" || fail "without scatter the table is another"

# A charge of 60 mm in the second hole; the table is written over, as another rank reads it.
cat >"$out/in.zones" <<'END'
units si
atom_style granular
charge_design explosive emulsion charge_diameter 0.06 coupling water poisson_ratio 0.25 crushed_ratio 3 hole_table ${table} crushed_table ${table}
print "smallest ${pattern_crushed_radius} full ${pattern_full_radius}"
END
for ranks in 1 2; do
  cp "$out/new/1.csv" "$out/zones$ranks.csv"
  on_ranks "$ranks" -in "$out/in.zones" -log none -var table "$out/zones$ranks.csv" >"$out/screen_zones$ranks"
  # 3 x 44.5 mm x (60/89)^(0.72/1.5)
  grep -q '^smallest 0\.11048.* full 0\.1335$' "$out/screen_zones$ranks" || fail "the crushed zones are others: $(tail -n 3 "$out/screen_zones$ranks")"
done
cmp "$out/zones1.csv" "$out/zones2.csv" || fail "the crushed zones of one and two ranks differ"
[[ $(grep -c ',0\.11048[0-9]*$' "$out/zones1.csv") -eq 6 ]] || fail "not six crushed zones in the table"

# The face looks to the north: x is north of the origin, y west of it.
cat >"$out/plan.csv" <<'END'
NORTH,hole,1,478327.7000,6772294.1000,210.0000,478327.7000,6772294.1000,198.5000,165.0000,Production,NORTH:::1,0,#FFFFFF
NORTH,hole,2,478327.7000,6772299.1000,210.0000,478327.7000,6772299.1000,198.5000,165.0000,Production,NORTH:::1,42,#FFFFFF
END
cat >"$out/in.kirra" <<'END'
units si
atom_style granular
hole_pattern file ${table} kirra ${plan} throw_bearing 0 origin 478330 6772300 200 rows 1 holes_per_row 1 burden 4.6 spacing 5 bench_height 10 &
  stemming 3.5 hole_diameter 0.165 in_hole_delay 0.5
END
on_ranks 2 -in "$out/in.kirra" -log none -var plan "$out/plan.csv" -var table "$out/kirra.csv" >"$out/screen4"
diff - "$out/kirra.csv" <<END || fail "the holes of Kirra are in other places"
# holes of Kirra's file $out/plan.csv; origin in its coordinates 478330,6772300,200 m
hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,diameter_m,from_m,after,surface_delay_s,in_hole_delay_s
1,-5.9,2.3,10,-5.9,2.3,-1.5,0.165,3.5,,0,0.5
2,-0.9,2.3,10,-0.9,2.3,-1.5,0.165,3.5,1,0.042,0.5
END

# The quarry's rock without its blast. 0 0 0 of the survey, and of the plan, is at 500005 7000000 200 in the mine: the holes stand 3.5 m behind it.
awk -F, '/^[-0-9]/ { printf "%.2f,%.2f,%.2f\n", $1 + 500005, $2 + 7000000, $3 + 200; next } { print }' inputs/quarry/survey.csv >"$out/survey.csv"
cat >"$out/placed.csv" <<'END'
A,hole,1,500001.5,7000003,210,500001.5,7000003,199.25,89,Production,A:::1,0,red
A,hole,2,500001.5,7000006,210,500001.5,7000006,199.25,89,Production,A:::1,17,red
END
sed '/^# --- joints/,$d' inputs/quarry/in.quarry >"$out/in.quarry_cut"
cut_quarry() {  # cut_quarry FOLDER -var NAME VALUE...: to $out/FOLDER
  run_input "$1" 1 "$out/in.quarry_cut" -var block_min 0.7 -var block_max 2 -var fragment_x50 1.4 -var crushed_ratio 8 -var kirra "$out/placed.csv" "${@:2}"
}
place_of_run() { sed -nE 's/.*"terrain_(east|north|height)_m": ([0-9]+(\.[1-9])?).*/\2/p' "$out/$1/dump/scene.json" | tr '\n' ' '; }
cut_quarry surveyed -var terrain "$out/survey.csv" -var terrain_east 500005 -var terrain_north 7000000 -var terrain_height 200
[[ $(grep -c '^[12],-3.5,[36],10,-3.5,[36],-0.75,' "$out/surveyed/dump/holes.csv") -eq 2 ]] ||
  fail "holes of Kirra do not stand where the survey has them: $(cat "$out/surveyed/dump/holes.csv")"
cut_quarry plane
[[ $(grep -c '^[12],-2.5,-\?1.5,10,-2.5,-\?1.5,-0.75,' "$out/plane/dump/holes.csv") -eq 2 ]] ||
  fail "holes of Kirra alone do not set the place: $(cat "$out/plane/dump/holes.csv")"
[[ $(place_of_run surveyed) == "500005 7000000 200 " ]] || fail "place of the surveyed run: $(place_of_run surveyed)"
[[ $(place_of_run plane) == "500004 7000004.5 200 " ]] || fail "place of the run by the holes: $(place_of_run plane)"

# An explosive of one's own in one of these holes, water in the other; the table itself in mine coordinates.
printf 'name,density_kg_m3,vod_m_s,energy_J_kg\nours,950,4100,3.1e6\n' >"$out/ours.csv"
printf 'hole,explosive,coupling,charge_diameter_m\n1,ours,,\n2,,water,0.07\n' >"$out/charges.csv"
sed '/^# --- ground/,$d' inputs/quarry/in.quarry >"$out/in.quarry_cut"
cut_quarry charged -var explosive_table "$out/ours.csv" -var hole_charges "$out/charges.csv"
grep -q '^1,-2.5,-1.5,.*,ours,,' "$out/charged/dump/holes.csv" || fail "hole 1 lacks its explosive: $(cat "$out/charged/dump/holes.csv")"
# pi/4 8.55 m (0.089^2 950 + 0.07^2 800 kg/m3)
grep -q '"charge_mass_total_kg": 76.85' "$out/charged/dump/scene.json" || fail "mass: $(grep -o '"charge_mass_total[^,]*' "$out/charged/dump/scene.json")"
cmp "$out/ours.csv" "$out/charged/dump/explosives.csv" || fail "the explosives are not kept"

# Rock within a closed surface whose face overhangs by 0.8 m: fans over both ends, two triangles for each side.
awk 'function vertex(k, y) { split(corner[k % 6], c, " "); print "vertex " c[1] " " y " " c[2] }
  function facet(a, ya, b, yb, c, yc) { print "facet normal 0 0 0\nouter loop"; vertex(a, ya); vertex(b, yb); vertex(c, yc); print "endloop\nendfacet" }
  BEGIN { corner[0] = "-30 -8"; corner[1] = "4 -8"; corner[2] = "4 0"; corner[3] = "0 0"; corner[4] = "0.8 10"; corner[5] = "-30 10"
    print "solid body"
    for (k = 1; k < 5; k++) { facet(0, -20, k, -20, k + 1, -20); facet(0, 20, k + 1, 20, k, 20) }
    for (k = 0; k < 6; k++) { facet(k, -20, k, 20, k + 1, 20); facet(k, -20, k + 1, 20, k + 1, -20) }
    print "endsolid body" }' >"$out/body.stl"
sed '/^# --- joints/,$d' inputs/quarry/in.quarry >"$out/in.quarry_cut"
run_input overhang 1 "$out/in.quarry_cut" -var surface "$out/body.stl" -var rows 1 -var holes_per_row 2 -var hole_angle 90 -var face_angle 90 \
  -var block_min 0.7 -var block_max 1 -var fragment_x50 1 -var crushed_ratio 8
sed -nE 's/.*crushed zones [0-9.e+]+ m3 \(([-+0-9.e]+) %.*mean, ([0-9.e-]+) at most, ([0-9.e+]+) % .*/{"volume": \1, "near": \3}/p' "$out/overhang/screen" |
  tr -d '+' >"$out/overhang.json"
check_figures near "overhang: volume of the cut over that of the rock [%]" "$out/overhang.json:volume" 0 1

# The pattern takes charges by hole and scatter, too; another order of rows has the same times.
printf 'hole,explosive,coupling,charge_diameter_m\nr1h9,anfo,water,0.14\n' >"$out/wet.csv"
sed '/^# --- joints/,$d' inputs/pattern/in.pattern >"$out/in.pattern_cut"
{ sed -n 1p tests/regression/two_holes.csv; sed -n 3p tests/regression/two_holes.csv; sed -n 2p tests/regression/two_holes.csv; } >"$out/turned.csv"
for holes in tests/regression/two_holes.csv "$out/turned.csv"; do
  name=pattern_$(basename "$holes" .csv)
  run_input "$name" 1 "$out/in.pattern_cut" -var hole_table "$holes" -var hole_charges "$out/wet.csv" -var delay_scatter 0.02 -var delay_seed 3
  grep -q '^r1h9,.*,anfo,water,0.14,' "$out/$name/dump/holes.csv" || fail "hole r1h9 of the pattern is not wet: $(cat "$out/$name/dump/holes.csv")"
  awk -F, 'NR == 1 { for (k = 1; k <= NF; k++) if ($k == "scatter_s") c = k; next } { print $1, $c }' "$out/$name/dump/holes.csv" | sort >"$out/$name.times"
done
cmp "$out/pattern_two_holes.times" "$out/pattern_turned.times" || fail "scatter depends on the order of rows: $(cat "$out"/pattern_*.times)"
grep -q '^r1h9 -\?[0-9.e-]*[1-9]' "$out/pattern_turned.times" || fail "no scatter in the pattern: $(cat "$out/pattern_turned.times")"
