#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# run.sh [RESULTS [LIGGGHTS_MUCKPILE MUCKPILE_POST]]: a small bench blast, and the same with one thing changed at a time; exponents and ratios of
# what it answers, in the mean of three cuts. Writes RESULTS/answers.csv, RESULTS/summary.json and RESULTS/bench.csv, RESULTS/assumed.csv with the
# figures of all runs, which WRITE_PAGES=1 in the environment puts beside this file and into README.md; answers_report makes them. RESULTS is
# results/responses unless given.
# Two runs at once.
# Scope: fails if a figure is missing or outside what expected.json allows. The runs and the rows are in runs.txt, answers.txt beside this file.
set -euo pipefail
# shellcheck source=tests/support/validation_case.sh
source "$(dirname "${BASH_SOURCE[0]}")/../../../tests/support/validation_case.sh" responses "$@"

# blast SEED NAME SCENE [VAR VALUE]...: runs a scene in one cut until the burden is in flight.
blast() {
  local seed=$1 name=$2 scene=$3 fixed=()
  shift 3
  local out=$results/$name/$seed
  if [[ $scene != slice ]]; then
    # One cut for all that change explosive or rock: else blocks at the wall go with the crushed zone.
    fixed=(accuracy quick bench_height 4 time_end 0.1 widest_wall_block 6)
    [[ " $* " == *" block_min "* ]] || fixed+=(block_min 0.18)
    scene=inputs/bench/in.bench
    [[ " $* " == *" burden "* ]] || fixed+=(burden 1.8)
    [[ " $* " == *" hole_diameter "* ]] || fixed+=(hole_diameter 0.06)
  else
    fixed=(thickness 2.4)
    [[ " $* " == *" hole_diameter "* ]] || fixed+=(hole_diameter 0.102)
    scene=inputs/validation/burden_velocity/in.burden_velocity
  fi
  run_input "$scene" "$out" "$@" "${fixed[@]}" seed "$seed"
  "$post" profile "$out" >"$out/profile.txt"
  echo "$name, cut $seed done"
}

# All runs, two at once; one that fails ends the script.
run_all() {
  local name words given seed
  while read -r name words; do
    rm -rf "${results:?}/$name"
    mapfile -t given < <(xargs -n1 <<<"$words")  # a value of several words is in quotes
    for seed in 1 2 3; do
      while (($(jobs -rp | wc -l) >= 2)); do wait -n; done
      blast "$seed" "$name" "${given[@]}" </dev/null &
    done
  done < <(grep '^[^#]' "$case_dir/runs.txt")
  while (($(jobs -p | wc -l) > 0)); do wait -n; done
}

run_all
pages=(bench= assumed=)
[[ -z ${WRITE_PAGES-} ]] || pages=(bench= "assumed=$case_dir/README.md")
"$(dirname "$check_program")/../answers_report/answers_report" "$case_dir" "$results" "${pages[@]}"
[[ -z ${WRITE_PAGES-} ]] || cp "$results/bench.csv" "$results/assumed.csv" "$case_dir"
check_figures exponents "$results/answers.csv" "$results/summary.json"
check_figures case "$case_dir/expected.json" "$results/summary.json"
