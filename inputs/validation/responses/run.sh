#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# run.sh [RESULTS [LIGGGHTS_MUCKPILE MUCKPILE_POST]]: a small bench blast, and the same with one thing changed at a time; exponents and ratios of what it
# answers. Writes RESULTS/answers.csv, RESULTS/summary.json and RESULTS/bench.md, RESULTS/assumed.md, the tables of README.md and docs/theory/charge.md,
# which WRITE_PAGES=1 in the environment puts there. RESULTS is results/responses unless given. Two runs at once.
# Scope: fails if a figure is missing or outside what expected.json allows. The runs and the rows are in runs.txt, answers.txt beside this file.
set -euo pipefail
# shellcheck source=tests/support/validation_case.sh
source "$(dirname "${BASH_SOURCE[0]}")/../../../tests/support/validation_case.sh" responses "$@"
readonly table=$results/answers.csv

# Lines of a file beside this script without comments and empty ones.
rows_of() { sed -e 's/[[:space:]]*#.*//' -e '/^[[:space:]]*$/d' "$case_dir/$1"; }

# blast NAME SCENE [VAR VALUE]...: runs a scene until the burden is in flight.
blast() {
  local name=$1 scene=$2 fixed=()
  shift 2
  if [[ $scene != slice ]]; then
    fixed=(accuracy quick bench_height 4 time_end 0.1)
    scene=inputs/bench/in.bench
    [[ " $* " == *" burden "* ]] || fixed+=(burden 1.8)
    [[ " $* " == *" hole_diameter "* ]] || fixed+=(hole_diameter 0.06)
  else
    fixed=(thickness 2.4 hole_diameter 0.102)
    scene=inputs/validation/burden_velocity/in.burden_velocity
  fi
  run_input "$scene" "$results/$name" "$@" "${fixed[@]}"
  "$post" profile "$results/$name" >"$results/$name/profile.txt"
  echo "$name done"
}

# All runs, two at once; one that fails ends the script.
run_all() {
  local name words
  while read -r name words; do
    while (($(jobs -rp | wc -l) >= 2)); do wait -n; done
    # shellcheck disable=SC2086
    blast "$name" $words </dev/null &
  done < <(rows_of runs.txt)
  while (($(jobs -p | wc -l) > 0)); do wait -n; done
}

# figure RUN QUANTITY: of its summary.json; or burden_speed_m_s, the way of the mass centre of the burden over the time; or load_work_J, of wave and gas.
figure() {
  local summary=$results/$1/summary.json
  case $2 in
    burden_speed_m_s) check_figures print "$summary:throw_cg_m" "$summary:physical_time_s" | awk '{ print $1 / $2 }' ;;
    load_work_J) check_figures print "$summary:wave_work_J" "$summary:gas_work_J" | awk '{ print $1 + $2 }' ;;
    *) check_figures print "$summary:$2" ;;
  esac
}

# A row per line of answers.txt: name, factor (or -), quantity, run, run to compare with (or -).
write_answers() {
  local name factor quantity run base value reference
  echo "name,factor,value,base" >"$table"
  while read -r name factor quantity run base; do
    value=$(figure "$run" "$quantity")
    reference=
    [[ $base == - ]] || reference=$(figure "$base" "$quantity")
    echo "$name,${factor/#-/},$value,$reference" | tee -a "$table"
  done < <(rows_of answers.txt)
}

# write_table SCENE: a line of Markdown per run of it: speeds, shares of the explosive's energy [%], when the stemming was out.
write_table() {
  local name scene rest out numbers summary
  echo "| run | face velocity, m/s | burden, m/s | over base | work of the wave | of the gas | crushing | heat into rock | vented | stemming | missing | stemming out, ms |"
  echo "|---|---|---|---|---|---|---|---|---|---|---|---|"
  while read -r name scene rest; do
    [[ $scene == "$1" || $name == base ]] || continue
    summary=$results/$name/summary.json
    out=$(figure "$name" stemming_out_s 2>/dev/null) || out=-
    numbers="$(figure base burden_speed_m_s) $(figure "$name" burden_speed_m_s) $(check_figures print "$summary:"{explosive_energy_J,face_velocity_mean_m_s} \
      "$summary:"{wave_work_J,gas_work_J} "$summary:energy_audit_J."{crushing,rock_heat,vented,stemming} "$summary:energy_audit_error") $out"
    awk -v name="$name" '{ printf "| %s | %.1f | %.2f | %.2f", name, $4, $2, $2 / $1; for (i = 5; i <= 10; ++i) printf " | %.1f", 100 * $i / $3
      printf " | %.2f | %s |\n", 100 * $11, $12 == "-" ? "-" : sprintf("%.1f", 1000 * $12) }' <<<"$numbers"
  done < <(rows_of runs.txt)
}

# fill_page PAGE SCENE: its table in a page, between a line <!-- runs: SCENE --> and the next <!-- end of runs -->.
fill_page() {
  local page
  page=$(awk -v mark="<!-- runs: $2 -->" -v table="$results/$2.md" '
    /^<!-- end of runs -->$/ { inside = 0 }
    !inside { print }
    $0 == mark { inside = 1; while ((getline line < table) > 0) print line }' "$1")
  printf '%s\n' "$page" >"$1"
}

run_all
write_answers
for kind in bench assumed; do write_table "$kind" | tee "$results/$kind.md"; done
if [[ -n ${WRITE_PAGES-} ]]; then
  fill_page "$case_dir/README.md" bench
  fill_page docs/theory/charge.md assumed
fi
check_figures exponents "$table" "$results/summary.json"
check_figures case "$case_dir/expected.json" "$results/summary.json"
