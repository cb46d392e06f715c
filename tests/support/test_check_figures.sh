#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# test_check_figures.sh CHECK_FIGURES: right figures pass; wrong ones, NaN, infinities, missing ones, and lists of expected values with a
# fault in them fail, each with its file, row and key.
# Scope: files made here.
set -euo pipefail
program=$(readlink -f "$1")
source "$(dirname "${BASH_SOURCE[0]}")/script.sh"
cd "$out"

call() {
  status=0
  output=$("$program" "$@" 2>&1) || status=$?
}
problem() {
  printf '%s\n' "test_check_figures: $1" "--- status $status, output:" "$output"
  exit 1
}
holds() {  # holds ARGUMENT...
  call "$@"
  [[ $status -eq 0 ]] || problem "must hold: $*"
}
fails() {  # fails STATUS TEXT ARGUMENT...: 1 for a wrong figure, 2 for one that cannot be had
  local wanted=$1 text=$2
  shift 2
  call "$@"
  [[ $status -eq $wanted ]] || problem "must fail with status $wanted: $*"
  grep -qF -- "$text" <<<"$output" || problem "does not tell '$text': $*"
}
expected() {  # expected ROW...: expected.json with these
  local IFS=,
  printf '{"case": "made up", "vars": "-var a 1 -var b 2",\n "expected": [%s]}\n' "$*" >expected.json
}
row() { printf '{"quantity": "%s", "value": %s, "tolerance": %s, "why": "so"}' "$@"; }  # row QUANTITY VALUE TOLERANCE

echo '{"blocks": 10, "throw_m": 8.5, "rest_deg": null, "word": "12", "still": true}' >summary.json
printf 'time_s,phase,work_J,balance,run_id\n0,wave,0,0,1e99999999999999\n1,throw,2.5e6,-0.001,1e99999999999999\n' >history.csv
printf 'time_s,work_J\n0,nan\n' >nan_first.csv
printf 'time_s,work_J\n0,\n' >gap_first.csv
printf 'time_s,work_J\n0,1\n1,abc\n' >word.csv
printf 'time_s,work_J\n0,0\n1,nan\n' >nan.csv
printf 'time_s,work_J\n0,0\n1,inf\n' >inf.csv
printf 'time_s,work_J\n0,0\n1\n' >ragged.csv
printf 'time_s,work_J\n0,0\n1,\n' >gap.csv
printf 'time_s,work_J\n' >no_rows.csv
echo '{"blocks": 10, "throw_m": nan}' >nan.json
echo '{"blocks": 10, "throw_m": 1e999}' >huge.json
: >empty.json
: >empty.csv

# A case.
expected "$(row blocks 10 0)" "$(row throw_m 8.4 0.11)" "$(row work_J 2.4e6 0.1e6)"
holds case expected.json summary.json history.csv
[[ $(grep -c ' ok$' <<<"$output") -eq 3 ]] || problem "three rows must be ok"
holds vars expected.json
[[ $output == '-var a 1 -var b 2' ]] || problem "vars must be printed as they are"
fails 1 'WRONG: no file has it' case expected.json summary.json
fails 2 'cannot be opened' case expected.json summary.json none.csv
fails 1 "nan.csv:3: work_J must be a finite number, got 'nan'" case expected.json summary.json nan.csv
fails 1 "inf.csv:3: work_J must be a finite number, got 'inf'" case expected.json summary.json inf.csv
fails 1 "gap.csv:3: work_J must be a finite number, got ''" case expected.json summary.json gap.csv
fails 1 'no_rows.csv: has no row' case expected.json summary.json no_rows.csv
fails 2 'ragged.csv:3: expected 2 fields, got 1' case expected.json summary.json ragged.csv
fails 2 'nan.json' case expected.json nan.json history.csv
fails 2 'huge.json' case expected.json huge.json history.csv
fails 2 'empty.json' case expected.json empty.json history.csv
fails 2 'empty.csv: has no header' case expected.json summary.json empty.csv
expected "$(row throw_m 8.3 0.1)"
fails 1 'WRONG' case expected.json summary.json
expected "$(row rest_deg 0 100)"
fails 1 'summary.json: rest_deg must be a finite number, got null' case expected.json summary.json
expected "$(row word 12 1)"
fails 1 'word must be a finite number, got "12"' case expected.json summary.json
expected "$(row still 1 1)"
fails 1 'still must be a finite number, got true' case expected.json summary.json

# Faults of the list itself: told before a run, by `vars`, and by `case`.
faulty() {  # faulty TEXT ROW...
  local text=$1
  shift
  expected "$@"
  fails 2 "$text" vars expected.json
  fails 2 "$text" case expected.json summary.json
}
good=$(row blocks 10 0)
faulty "expected must be a list with one row at least"
faulty "expected.json: row 2 of expected: unknown key 'tolerence'; did you mean 'tolerance'?" "$good" \
  '{"quantity": "throw_m", "value": 8.5, "tolerence": 1, "why": "so"}'
faulty "row 2 of expected: has no key 'value'" "$good" '{"quantity": "throw_m", "tolerance": 1, "why": "so"}'
faulty "row 1 of expected: has no key 'why'" '{"quantity": "throw_m", "value": 8.5, "tolerance": 1}'
faulty 'row 1 of expected: why must not be empty' '{"quantity": "throw_m", "value": 8.5, "tolerance": 1, "why": ""}'
faulty 'row 1 of expected: value must be a finite number, got "8.5"' "$(row throw_m '"8.5"' 1)"
faulty 'row 1 of expected: value must be a finite number, got null' "$(row throw_m null 1)"
faulty 'row 1 of expected: tolerance must be >= 0, got -1' "$(row throw_m 8.5 -1)"
faulty 'row 1 of expected: tolerance must be a finite number, got []' "$(row throw_m 8.5 '[]')"
faulty 'row 1 of expected: quantity must be a text, got 3' '{"quantity": 3, "value": 8.5, "tolerance": 1, "why": "so"}'
faulty "row 2 of expected: quantity 'blocks' is there twice" "$good" "$good"
faulty 'row 1 of expected: must be an object, got 7' 7
faulty 'expected.json' "$(row throw_m nan 1)"
faulty 'expected.json' "$(row throw_m 8.5 1e999)"
echo '{"case": "x", "vras": "", "expected": []}' >expected.json
fails 2 "expected.json: unknown key 'vras'; did you mean 'vars'?" vars expected.json
echo '{"case": "x", "vars": "", "expected": {}}' >expected.json
fails 2 'expected must be a list' vars expected.json
echo '{"case": "x", "vars": ""}' >expected.json
fails 2 "has no key 'expected'" vars expected.json
printf '{"case": "x", "expected": [%s]}' "$good" >expected.json
fails 2 "has no key 'vars'" vars expected.json
holds case expected.json summary.json

# Single figures.
holds near work history.csv:work_J 2.4e6 0.05 --share
fails 1 'WRONG' near work history.csv:work_J 2.4e6 0.04 --share
fails 1 'WRONG' near work history.csv:work_J 2.6e6 0.9e5
holds near work history.csv:work_J history.csv:work_J 0
holds near mean 'history.csv:mean(work_J)' 1.25e6 0
fails 2 "history.csv: has no 'wrok_J'" near work history.csv:wrok_J 2.4e6 1
fails 2 "got ''" near work '' 2.4e6 1
fails 2 "got 'nan'" near work nan 0 1
fails 2 "got 'inf'" near work 1 inf 1
fails 2 'bound must be >= 0' near work 1 1 nan
fails 2 'bound must be >= 0' near work 1 1 -1
fails 2 'reference is 0' near work 1 0 1 --share
fails 2 'nan.csv:3' near work nan.csv:work_J 0 1e9
fails 2 'nan.csv:3' near work 'nan.csv:mean(work_J)' 0 1e9
fails 2 'no_rows.csv: has no row' near work 'no_rows.csv:mean(work_J)' 0 1e9
holds bounds throw summary.json:throw_m --above 8 --at-least 8.5 --at-most summary.json:blocks --below 9
fails 1 'must be < 8.5' bounds throw summary.json:throw_m --below 8.5
fails 1 'must be > 8.5' bounds throw summary.json:throw_m --above 8.5
fails 1 'must be >= 8.6' bounds throw summary.json:throw_m --at-least 8.6
fails 1 'must be <= 8' bounds throw summary.json:throw_m --at-most summary.json:blocks --times 0.8
fails 1 'WRONG' bounds throw summary.json:throw_m --below 9 --times nan
fails 2 'one bound at least' bounds throw summary.json:throw_m
fails 2 "has no 'none'" bounds throw summary.json:none --below 9
holds print summary.json:blocks history.csv:work_J
[[ $output == '10 2500000' ]] || problem "two figures in one line"
fails 2 'got null' print summary.json:rest_deg
fails 2 "cannot be opened" finite history.csv none.csv
holds finite history.csv
fails 2 'nan.csv:3' finite history.csv nan.csv
fails 2 'gap.csv:3' finite gap.csv
fails 2 'nan_first.csv:2' finite nan_first.csv
fails 2 'gap_first.csv:2' finite gap_first.csv
fails 2 'word.csv:3' finite word.csv
fails 2 'has no row' finite no_rows.csv
fails 2 'rest_deg must have a value, got null' finite summary.json
fails 2 'nan.json' finite nan.json

# v = 2 W^-0.5; work 1 and 2 of 10.
table() { printf 'burden_m,seed,face_velocity_m_s,wave_work_J,gas_work_J,explosive_energy_J\n%s' "$1" >table.csv; }
table $'1,1,2,1,2,10\n4,1,1,1,2,10\n'
fails 2 'no run with a burden of 3 m' burden_fit table.csv fit.json
table $'0.75,1,2,1,2,10\n3,1,1,1,2,10\n'
holds burden_fit table.csv fit.json
printf '{"case": "fit", "expected": [%s, %s, %s, %s]}' "$(row burden_velocity_exponent -0.5 1e-12)" "$(row velocity_at_3_m_m_s 1 1e-12)" \
  "$(row wave_efficiency_at_3_m 0.1 1e-12)" "$(row gas_efficiency_at_3_m 0.2 1e-12)" >expected.json
holds case expected.json fit.json
table ''
fails 2 'two burdens' burden_fit table.csv fit.json
table $'3,1,1,1,2,10\n'
fails 2 'two burdens' burden_fit table.csv fit.json
table $'0.75,1,nan,1,2,10\n3,1,1,1,2,10\n'
fails 2 'table.csv:2: face_velocity_m_s must be a finite number' burden_fit table.csv fit.json
table $'0.75,1,-2,1,2,10\n3,1,1,1,2,10\n'
fails 2 'table.csv:2: face_velocity_m_s must be > 0' burden_fit table.csv fit.json

# Twice the energy, twice the square of the speed; half of it, a quarter.
printf 'name,factor,value,base\nenergy,2,2,1.41421356237\nmass,2,4,1\nmass,0.5,0.5,1\n' >answers.csv
holds exponents answers.csv answers.json
printf '{"case": "answers", "expected": [%s, %s, %s]}' "$(row energy_exponent 0.5 1e-9)" "$(row mass_at_2_exponent 2 1e-12)" \
  "$(row mass_at_0.5_exponent 1 1e-12)" >expected.json
holds case expected.json answers.json
printf 'name,factor,value,base\nenergy,1,2,1\n' >answers.csv
fails 2 'answers.csv:2: factor must not be 1' exponents answers.csv answers.json
printf 'name,factor,value,base\nenergy,2,0,1\n' >answers.csv
fails 2 'answers.csv:2: value must be > 0' exponents answers.csv answers.json
# Without a factor the ratio, without a base the value.
printf 'name,factor,value,base\nprimer,,3,4\nstemming_out_s,,0.015,\n' >answers.csv
holds exponents answers.csv answers.json
printf '{"case": "answers", "expected": [%s, %s]}' "$(row primer_ratio 0.75 1e-12)" "$(row stemming_out_s 0.015 0)" >expected.json
holds case expected.json answers.json
printf 'name,factor,value,base\nprimer,,3,4\nprimer,,3,4\n' >answers.csv
fails 2 'primer_ratio is there twice' exponents answers.csv answers.json

# A charge of 10 kg/m: 0.7 m/s by the law at 10 pi m; a quarter of that at twice the distance is 0.25 2^0.7 = 0.406126 of the law.
mkdir -p slice/dump
echo '{"charge_length_m": 1, "subdrill_m": 0}' >slice/dump/scene.json
peaks() { printf 'gauge,z_m,distance_m,scaled_distance_m_kg05,ppv_m_s\n%s' "$1" >slice/ppv.csv; }
peaks $'1,0,31.4159265359,9.93458827190,0.7\n2,0,62.8318530718,19.8691765438,0.175\n3,0,90,28.46,5\n'
holds near_field field.json 30 70 slice/
printf '{"case": "slice", "expected": [%s, %s, %s, %s]}' "$(row slice_over_law 0.637280 1e-6)" "$(row slice_over_law_least 0.406126 1e-6)" \
  "$(row slice_over_law_most 1 1e-9)" "$(row slice_distance_exponent -2 1e-9)" >expected.json
holds case expected.json field.json
fails 2 'needs two gauges between 80 and 100 m' near_field field.json 80 100 slice
fails 2 'none/dump/scene.json' near_field field.json 30 70 none
fails 2 'slice is there twice' near_field field.json 30 70 slice ./slice/
fails 2 '0 < NEAREST < FARTHEST' near_field field.json 70 30 slice
fails 2 '0 < NEAREST < FARTHEST' near_field field.json 30 nan slice
peaks $'1,0,31.4,9.9,0.7\n2,0,31.4,9.9,0.7\n'
fails 2 'has gauges at one distance only' near_field field.json 30 70 slice
peaks $'1,0,31.4,9.9,0\n2,0,62.8,19.9,0.7\n'
fails 2 'ppv.csv:2: ppv_m_s must be > 0' near_field field.json 30 70 slice

# Of half the pressure the exact wave is half as fast. Far from its cavity it falls by the power -0.5.
peaks $'1,0,31.4159265359,9.93458827190,0.7\n2,0,62.8318530718,19.8691765438,0.175\n'
for peak in 1e8 2e8; do
  holds near_field elastic_$peak.json 30 70 slice --pulse $peak 1e-4 0.15 --rock 2650 55e9 0.25
done
holds bounds half elastic_1e8.json:slice_over_elastic --at-least elastic_2e8.json:slice_over_elastic --times 1.999999
holds bounds half elastic_1e8.json:slice_over_elastic --at-most elastic_2e8.json:slice_over_elastic --times 2.000001
holds near cylinder elastic_1e8.json:slice_elastic_exponent -0.5 0.01
fails 2 '--rock' near_field field.json 30 70 slice --pulse 1e8 1e-4 0.15
fails 2 'must be > 0' near_field field.json 30 70 slice --pulse 0 1e-4 0.15 --rock 2650 55e9 0.25

# A charge of 2/pi kg/m, from z = -1 to 1 m: by the law 0.7 (atan(a/r) + atan(b/r))^0.7 (2/(pi r))^0.7 m/s, which is 0.7 at r = 1, 0.7 0.512559 at 3^0.5
# and 0.7 0.425645 at r = 1, 1 m above the end. Speeds are once and half of it there, twice of it above.
echo '{"charge_length_m": 2, "subdrill_m": 1}' >slice/dump/scene.json
peaks $'1,0,1,0.886226925453,0.7\n2,0,1.73205080757,1.53499006192,0.179395573925\n3,2,1.41421356237,1.25331413732,0.595903229244\n4,2,2,1.77245385091,0.441723717232\n'
holds hole_vibration hole.json slice --distances 1 2
printf '{"case": "hole", "expected": [%s, %s, %s, %s, %s]}' "$(row slice_at_0_from_100_over_law 0.707106781 1e-8)" \
  "$(row slice_at_0_from_100_law_exponent -1.216698345 1e-8)" "$(row slice_at_0_from_100_distance_exponent -2.478557852 1e-8)" \
  "$(row slice_at_200_from_100_over_law 2 1e-8)" "$(row slice_over_bureau_most 0.6766407838 1e-8)" >expected.json
holds case expected.json hole.json
fails 2 'has gauges at one distance only' hole_vibration hole.json slice --distances 1 1.5 2
fails 2 'slice is there twice' hole_vibration hole.json slice ./slice/ --distances 1 2
fails 2 'two distances' hole_vibration hole.json slice --distances 2 1

# A figure within a figure.
echo '{"audit_J": {"vented": 3, "deep": {"er": 4}, "word": "x"}, "a.b": 5}' >inner.json
holds near vented inner.json:audit_J.vented 3 0
holds near deeper inner.json:audit_J.deep.er 4 0
holds near dotted inner.json:a.b 5 0
fails 2 "has no 'audit_J.none'" print inner.json:audit_J.none
fails 2 "has no 'audit_J.vented.none'" print inner.json:audit_J.vented.none
fails 2 'must be a finite number' print inner.json:audit_J.word

# K = 1.5: 12 kg at 2 m have n = 1, a radius of 2 m and a pit of 0.66 m; at 3 m 0.4 K w^3 = 16.2 kg is more than the charge.
craters() { printf 'charge_mass_kg,burial_depth_m,crater_radius_m,crater_volume_m3,apparent_crater_depth_m\n%s' "$1" >craters.csv; }
craters $'12,1,2,3,0\n12,2,1,4,0.33\n12,2,2,8,0.99\n12,3,0,0,\n'
holds crater_depths craters.csv craters.json
printf '{"case": "craters", "expected": [%s, %s, %s, %s, %s]}' "$(row volume_maxima 1 0)" "$(row largest_volume_at_m_kg13 0.87 1e-9)" \
  "$(row crater_volume_m3_at_87 6 1e-12)" "$(row radius_over_boreskov_at_87 0.75 1e-9)" "$(row apparent_over_pokrovskii_at_87 1 1e-9)" >expected.json
holds case expected.json craters.json
craters $'12,1,2,3,0\n12,2,1,2,0\n12,3,2,8,0\n'
holds crater_depths craters.csv craters.json
printf '{"case": "craters", "expected": [%s]}' "$(row volume_maxima 2 0)" >expected.json
holds case expected.json craters.json
craters $'12,1,2,3,0\n12,2,1,2,0\n'
fails 2 'three depths' crater_depths craters.csv craters.json
craters $'12,1,-2,3,0\n12,2,1,2,0\n12,3,1,2,0\n'
fails 2 'craters.csv:2: crater_radius_m must be >= 0' crater_depths craters.csv craters.json

call count craters.csv burial_depth_m 2
[[ $status -eq 0 && $output == 2 ]] || problem 'must count the rows with 2 m at least'
fails 2 'width_m' count craters.csv width_m 2

# Throws of 0.01 and 0.25 burdens at 1 and 4 kg/m3: 0.05 lies half way in the logarithms.
limits() { printf 'burden_m,charge_kg,throw_m\n%s' "$1" >limits.csv; }
limits $'2,32,0.7\n2,8,0.02\n2,32,0.3\n0.5,0.125,0.025\n0.5,0.0625,0\n'
holds limit_charges limits.csv limits.json
printf '{"case": "limits", "expected": [%s, %s, %s]}' "$(row limit_kg_m3_at_200 2 1e-12)" "$(row limit_over_langefors_at_200 5.314437556 1e-9)" \
  "$(row limit_kg_m3_at_50 1 1e-9)" >expected.json
holds case expected.json limits.json
limits $'2,8,0.2\n2,32,0.5\n'
fails 2 'no charge whose throw is below' limit_charges limits.csv limits.json
limits $'2,0,0.2\n'
fails 2 'limits.csv:2: charge_kg must be > 0' limit_charges limits.csv limits.json

fails 2 '' neer
holds --help
holds near --help
