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
charge_design explosive anfo hole_table ${table}
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

# A charge of 60 mm in the second hole; the table is written over, as another rank reads it.
cat >"$out/in.zones" <<'END'
units si
atom_style granular
charge_design explosive emulsion charge_diameter 0.06 coupling water poisson_ratio 0.25 hole_table ${table} crushed_table ${table}
print "smallest ${pattern_crushed_radius} full ${pattern_full_radius}"
END
for ranks in 1 2; do
  cp "$out/new/1.csv" "$out/zones$ranks.csv"
  on_ranks "$ranks" -in "$out/in.zones" -log none -var table "$out/zones$ranks.csv" >"$out/screen_zones$ranks"
  # 3 x 44.5 mm x (60/89)^(0.72 x 3/7)
  grep -q '^smallest 0\.11820.* full 0\.1335$' "$out/screen_zones$ranks" || fail "the crushed zones are others: $(tail -n 3 "$out/screen_zones$ranks")"
done
cmp "$out/zones1.csv" "$out/zones2.csv" || fail "the crushed zones of one and two ranks differ"
[[ $(grep -c ',0\.11820[0-9]*$' "$out/zones1.csv") -eq 6 ]] || fail "not six crushed zones in the table"

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
