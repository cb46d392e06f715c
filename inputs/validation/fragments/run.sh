#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# run.sh [RESULTS [LIGGGHTS_MUCKPILE MUCKPILE_POST]]: fragments of a bench at 0.23 kg/m3 in blocks of 1, 1.4 and 2 times the size: what of them the cut
# makes, and what the blast leaves together. Writes RESULTS/fragments.csv and RESULTS/summary.json. RESULTS is results/fragments unless given.
# Scope: fails if a figure is missing or outside what expected.json allows.
set -euo pipefail
# shellcheck source=tests/support/validation_case.sh
source "$(dirname "${BASH_SOURCE[0]}")/../../../tests/support/validation_case.sh" fragments "$@"
table=$results/fragments.csv
echo "name,factor,value,base" >"$table"

# bench SCALE X50 BLOCK_MIN BLOCK_MAX: a run, and the sizes of its fragments.
bench() {
  local out=$results/x$1
  run_input inputs/bench/in.bench "$out" accuracy quick explosive anfo hole_diameter 0.102 bench_height 9 burden 4 \
    fragment_x50 "$2" block_min "$3" block_max "$4"
  "$post" profile "$out" >/dev/null
  "$post" fragments "$out" --boulder 1.7
}
# figure SCALE KEY: of the run's summary.
figure() { check_figures print "$results/x$1/summary.json:$2"; }

bench 1 0.34 0.235 0.65
bench 1.4 0.48 0.33 0.91
bench 2 0.68 0.47 1.3
for scale in 1.4 2; do
  for key in sieve_p20_m sieve_p50_m block_sieve_coarsest_m; do
    echo "$key,$scale,$(figure $scale $key),$(figure 1 $key)" >>"$table"
  done
done
for scale in 1 1.4 2; do
  for key in boulder_mass_fraction sieve_p80_m sieve_largest_m joints_broken_fraction throw_cg_m; do
    echo "${key}_x$scale,,$(figure $scale $key)," >>"$table"
  done
done
check_figures exponents "$table" "$results/summary.json"
check_figures case "$case_dir/expected.json" "$results/summary.json" "$results/x1/summary.json"
