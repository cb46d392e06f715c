#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# run.sh [RESULTS [LIGGGHTS_MUCKPILE MUCKPILE_POST]]: constants of a blast that was itself simulated, found by muckpile-post calibrate from its throw,
# toe, height and speed, and checked on another burden; and each run of the sweep in turn taken for the measured blast, its constants found from the
# others. Writes RESULTS/found.csv and RESULTS/others.csv, the tables of README.md, and RESULTS/summary.json. RESULTS is results/calibrate unless
# given. Thirteen runs, one after the other.
# Scope: fails if a figure is missing or outside what expected.json allows.
set -euo pipefail
# shellcheck source=tests/support/validation_case.sh
source "$(dirname "${BASH_SOURCE[0]}")/../../../tests/support/validation_case.sh" calibrate "$@"
readonly true_share=0.7 true_grain=7e-4
readonly figures=(throw_cg_m pile_toe_m pile_height_m face_velocity_mean_m_s)
readonly uncertainties=(0.3 1.0 0.1 0.5)  # of a survey and of a fast camera

# blast OUT BURDEN SEED SHARE GRAIN
blast() {
  run_input inputs/bench/in.bench "$results/$1" accuracy quick bench_height 4 hole_diameter 0.06 burden "$2" seed "$3" energy_share "$4" crushed_grain "$5"
  "$post" profile "$results/$1" >/dev/null
  echo "$1 done"
}

# measure TABLE RUN: its figures as if they had been measured.
measure() {
  local k value
  echo "figure,value,uncertainty" >"$results/$1"
  for k in "${!figures[@]}"; do
    value=$(check_figures print "$results/$2/summary.json:${figures[k]}")
    echo "${figures[k]},$value,${uncertainties[k]}" >>"$results/$1"
  done
}

# Each run has a seed of its own, so that the surfaces know how much seeds do.
sweep() {
  local share grain seed=0
  echo "folder,state,energy_share,crushed_grain" >"$results/sweep_runs.csv"
  for share in 0.5 0.7071 1; do
    for grain in 5e-4 1e-3 2e-3; do
      seed=$((seed + 1))
      blast "run_$seed" 1.8 "$seed" "$share" "$grain"
      echo "run_$seed,done,$share,$grain" >>"$results/sweep_runs.csv"
    done
  done
}

# of CSV ROW COLUMN: a number of a table, its rows by their first word.
of() {
  awk -F, -v row="$2" -v column="$3" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == column) at = i }
    $1 == row { print $at; found = 1 } END { exit !found }' "$results/$1"
}

# off_by FOLDER CONSTANT TRUE: of the estimate there, in its standard errors.
off_by() {
  awk -v found="$(of "$1calibrate.csv" "$2" estimate)" -v is="$3" -v error="$(of "$1calibrate.csv" "$2" standard_error_ln)" 'BEGIN { print log(found / is) / error }'
}

# from_others K SHARE GRAIN: run K of the sweep as the measured blast.
from_others() {
  local folder=without_$1 k
  rm -rf "${results:?}/$folder" && mkdir "$results/$folder"
  for ((k = 1; k <= 9; ++k)); do ln -s "../run_$k" "$results/$folder/run_$k"; done
  grep -v "^run_$1," "$results/sweep_runs.csv" >"$results/$folder/sweep_runs.csv"
  measure "$folder/measured.csv" "run_$1"
  "$post" calibrate fit "$results/$folder/measured.csv" "$results/$folder" --site others >"$results/$folder/fit.txt"
  echo "$1,$2,$(of "$folder/calibrate.csv" energy_share estimate),$(off_by "$folder/" energy_share "$2"),$3,$(off_by "$folder/" crushed_grain "$3")" |
    tee -a "$results/others.csv"
}

# found CONSTANT TRUE: a row of found.csv, and how far off it is in standard errors.
found() {
  local estimate low high error told off
  estimate=$(of calibrate.csv "$1" estimate) low=$(of calibrate.csv "$1" low) high=$(of calibrate.csv "$1" high)
  error=$(of calibrate.csv "$1" standard_error_ln) told=$(of calibrate.csv "$1" told_fraction)
  off=$(off_by "" "$1" "$2")
  echo "$1,$2,$estimate,$low,$high,$told,$off" | tee -a "$results/found.csv"
  echo "\"$1_found\": $estimate, \"$1_standard_error_ln\": $error, \"$1_told_fraction\": $told, \"$1_off\": $off," >>"$results/summary.json.part"
}

blast measured_1 1.8 101 "$true_share" "$true_grain"
blast measured_2 2.1 102 "$true_share" "$true_grain"
measure blast_1.csv measured_1
measure blast_2.csv measured_2
sweep
"$post" calibrate fit "$results/blast_1.csv" "$results" --site found | tee "$results/fit.txt"

echo "constant,true,found,low,high,told_fraction,off_by_standard_errors" >"$results/found.csv"
rm -f "$results/summary.json.part"
found energy_share "$true_share"
found crushed_grain "$true_grain"

share=$(of calibrate.csv energy_share estimate) grain=$(of calibrate.csv crushed_grain estimate)
blast found_1 2.1 103 "$share" "$grain"
blast found_2 2.1 104 "$share" "$grain"
"$post" calibrate check "$results/blast_2.csv" "$results/found_1" "$results/found_2" --site "$results/site_found.in" --csv "$results/check.csv" |
  tee "$results/check.txt" || (($? == 1))
worst=$(awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "off_by_deviations") at = i }
  NR > 1 { off = $at < 0 ? -$at : $at; if (off > worst) worst = off } END { print worst + 0 }' "$results/check.csv")

echo "run,energy_share,found,off_by_standard_errors,crushed_grain,off_by_standard_errors" >"$results/others.csv"
while IFS=, read -r run state share grain; do
  [[ $state != 'done' ]] || from_others "${run#run_}" "$share" "$grain"
done <"$results/sweep_runs.csv"
others=$(awk -F, 'NR > 1 { sum += $4 * $4; error = log($3 / $2); of += error * error; ++n }
  END { printf "\"others_off_rms\": %g, \"others_error_ln_rms\": %g,", sqrt(sum / n), sqrt(of / n) }' "$results/others.csv")

echo "{$others $(cat "$results/summary.json.part") \"check_worst_off\": $worst}" >"$results/summary.json"
rm "$results/summary.json.part"
check_figures case "$case_dir/expected.json" "$results/summary.json"
