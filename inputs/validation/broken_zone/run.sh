#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# run.sh [RESULTS [LIGGGHTS_MUCKPILE MUCKPILE_POST]]: how far one charge breaks endless rock, for three block sizes, two seeds, another hole, another explosive.
# Writes RESULTS/zones.csv and RESULTS/summary.json. RESULTS is results/broken_zone unless given.
# Scope: takes the programs of build/release unless others are named; fails if a figure is missing or outside what expected.json allows.
set -euo pipefail
root=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../../..")
case_dir=inputs/validation/broken_zone
cd "$root"
results=${1:-results/broken_zone}
program=${2:-build/release/src/app/liggghts-muckpile} post=${3:-build/release/postproc/tools/muckpile-post}
source tests/support/check_figures.sh
mkdir -p "$results"
table=$results/zones.csv
figures=()
echo "run,half_radius_m,tenth_radius_m,half_hole_radii,tenth_hole_radii" >"$table"

# zone NAME [VAR VALUE]...: a row of the table, and two figures of the summary.
zone() {
  local name=$1 out=$results/$1 words=() row half tenth
  shift
  while (($#)); do
    words+=(-var "$1" "$2")
    shift 2
  done
  rm -rf "$out" && mkdir -p "$out/dump"
  OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_btl_vader_single_copy_mechanism=none \
    mpirun -np 1 --bind-to none "$program" -in $case_dir/in.broken_zone -log none -var out "$out" "${words[@]}" >"$out/screen"
  "$post" damage "$out"
  row=$(check_figures print "$out"/summary.json:damage_{half_radius_m,tenth_radius_m,half_hole_radii,tenth_hole_radii})
  echo "$name,${row// /,}" | tee -a "$table"
  read -r _ _ half tenth <<<"$row"
  figures+=("\"${name}_half_hole_radii\": $half" "\"${name}_tenth_hole_radii\": $tenth")
}

zone standard
zone standard_seed_2 seed 2
zone fine fragment_x50 0.2 block_min 0.14 block_max 0.3
zone coarse fragment_x50 0.4 block_min 0.3 block_max 0.8
zone hole_89_mm hole_diameter 0.089
zone emulsion explosive emulsion
(IFS=,; echo "{${figures[*]}}") >"$results/summary.json"
check_figures case $case_dir/expected.json "$results/summary.json"
