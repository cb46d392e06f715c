#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# test_answers_report.sh ANSWERS_REPORT: the tables of the case responses, from made-up figures whose ratios are seen at a glance; what is missing is told of.
set -euo pipefail
report=$(readlink -f "$1")
source "$(dirname "${BASH_SOURCE[0]}")/script.sh"
cd "$out"

is() { diff "$1" - || fail "$1 is not as it should be"; }  # is FILE: as on standard input

refuses() {  # refuses TEXT COMMAND...
  ! output=$("${@:2}" 2>&1) || fail "accepted: ${*:2}"
  grep -qF -- "$1" <<<"$output" || fail "does not tell '$1' but '$output'"
}

one_run() {  # one_run NAME/CUT THROW WAVE [MORE]
  mkdir -p "results/$1"
  echo "{\"throw_cg_m\": $2, \"physical_time_s\": 0.5, \"face_velocity_mean_m_s\": 12.34, \"explosive_energy_J\": 200, \"wave_work_J\": $3,
    \"gas_work_J\": 20, \"energy_audit_J\": {\"crushing\": 40, \"rock_heat\": 80, \"vented\": 10, \"stemming\": 2}, \"energy_audit_error\": 0.001${4-}}" \
    >"results/$1/summary.json"
}
one_run base/1 2 9 ', "stemming_out_s": 0.008'
one_run base/2 4 11 ', "stemming_out_s": 0.0096'
one_run half/1 1.5 5 ', "stemming_out_s": null'
one_run half/2 1.5 5 ', "stemming_out_s": 0.02'
one_run grain/1 2.4 10
one_run fine/1 3 12
mkdir case
printf '# NAME SCENE\nbase bench\n\nhalf bench energy_share 0.5 # so\ngrain assumed crushed_grain 1\nfine slice\n' >case/runs.txt
printf '# NAME\nenergy 0.5 burden_speed_m_s half base\nload - load_work_J fine base\nvented - energy_audit_J.vented base -\n' >case/answers.txt
printf 'A\n<!-- runs: bench -->\nold\n<!-- end of runs -->\nB\n<!-- runs: assumed -->\n<!-- end of runs -->\n' >page.md

"$report" case results bench=page.md assumed= >screen
is results/answers.csv <<'EOT'
name,factor,value,base
energy,0.5,3,6
load,,32,30
vented,,10,
EOT
is page.md <<'EOT'
A
<!-- runs: bench -->
| run | burden, m/s | over base | wave | gas |
|---|---|---|---|---|
| base | 6.00 | 1.00 | 5.0 | 10.0 |
| half | 3.00 | 0.50 | 2.5 | 10.0 |
<!-- end of runs -->
B
<!-- runs: assumed -->
<!-- end of runs -->
EOT
is results/assumed.csv <<'EOT'
run,face_velocity_mean_m_s,burden_speed_m_s,burden_speed_over_base,wave_work_percent,gas_work_percent,crushing_percent,rock_heat_percent,vented_percent,stemming_percent,missing_percent,stemming_out_ms
base,12.3,6.00,1.00,5.0,10.0,20.0,40.0,5.0,1.0,0.10,8.8
grain,12.3,4.80,0.80,5.0,10.0,20.0,40.0,5.0,1.0,0.10,
EOT
refuses "page.md: has no line '<!-- runs: slice -->'" "$report" case results slice=page.md
refuses "needs SCENE=PAGE, got 'bench'" "$report" case results bench
sed -i '$d' page.md
refuses "page.md: has no line '<!-- end of runs -->'" "$report" case results assumed=page.md
one_run half/2 null 5
refuses "half/2/summary.json: throw_cg_m must be a finite number, got null" "$report" case results
echo 'short 0.5 load_work_J base' >case/answers.txt
refuses "a row must be NAME FACTOR QUANTITY RUN BASE, got 'short' with 4 words" "$report" case results
echo 'whole 0.5 load_work_J base -' >case/answers.txt
rm results/base/2/summary.json
refuses "results/base/2/summary.json: cannot be opened" "$report" case results bench=
touch results/base/notes.txt
rm -r results/base/[12]
refuses "results/base: has no folder of a cut" "$report" case results bench=
rm -r results/base
refuses "results/base: has no folder of a cut" "$report" case results bench=
