#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# ladder.sh LIGGGHTS_MUCKPILE MUCKPILE_POST LADDER_REPORT OUT [quick]: run time against error of a bench of half the height, one knob at a time; writes
# OUT/ladder.csv, OUT/ladder.md, OUT/scatter.md and OUT/cases/ladder.json.
# Scope: CPU seconds of one rank, so that other work on the machine and runs side by side disturb little. Error: distance from the run that
# is finest in everything. `quick` ends the runs earlier: a trial of the command, not a result.
set -euo pipefail
program=$(readlink -f "$1") post=$(readlink -f "$2") report=$(readlink -f "$3") out=$(realpath -m "$4") quick=${5-}
root=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../..")
# Of tests/regression/bench_small.json; long enough for the burden to land. One rock has one spacing of the cracks that gas finds, whatever its
# blocks (inputs/bench/README.md): that of the smallest blocks of the finest run.
bench="-var bench_height 5 -var burden 2 -var hole_diameter 0.064 -var crack_spacing 0.126 -var time_end 3.0"
[[ $quick != quick ]] || bench=${bench/time_end 3.0/time_end 0.2}
readonly bench
export OMPI_MCA_btl_vader_single_copy_mechanism=none

# The sizes of the standard blocks (median, smallest, largest) times a factor. At the wall of the crushed zone, 0.192 m wide here,
# the inputs cut blocks down to it.
sizes() { "$(dirname "$report")/log_figures" sizes 0.35 0.18 0.50 "$1" 0.19; }

# name|knob|setting|variables; the knob groups the points of a plot. The finest run is the longest, so it starts first.
ladder=(
  "finest|finest|blocks x 0.7, 8 spheres, half the step, 4 x stiffer|$(sizes 0.7) -var spheres_per_block 8 -var wave_share 0.45 -var gas_every 1 -var gas_substeps 8 -var steps_per_contact 30 -var contact_modulus 1e8 -var softening 1.5e-3 -var push_softening 1 -var sleep 0"
  "size_0.7|block size|x 0.7|$(sizes 0.7)"
  "size_0.85|block size|x 0.85|$(sizes 0.85)"
  "standard|standard|seed 1|$(sizes 1)"
  "size_1.2|block size|x 1.2|$(sizes 1.2)"
  "size_1.4|block size|x 1.4|$(sizes 1.4)"
  "seed_2|standard|seed 2|$(sizes 1) -var seed 2"
  "seed_3|standard|seed 3|$(sizes 1) -var seed 3"
  "spheres_3|spheres per block|3|$(sizes 1) -var spheres_per_block 3"
  "spheres_8|spheres per block|8|$(sizes 1) -var spheres_per_block 8"
  "share_0.35|first phase: step over the stable one|0.35|$(sizes 1) -var wave_share 0.35"
  "gas_substeps_8|substeps of the gas|8|$(sizes 1) -var gas_substeps 8"
  "steps_15|steps per contact|15|$(sizes 1) -var steps_per_contact 15"
  "steps_30|steps per contact|30|$(sizes 1) -var steps_per_contact 30"
  "softening_low|softening|9.4e-5|$(sizes 1) -var softening 9.4e-5"
  "softening_high|softening|1.5e-3|$(sizes 1) -var softening 1.5e-3"
  "modulus_low|contact modulus|6.25e6 Pa|$(sizes 1) -var contact_modulus 6.25e6"
  "modulus_high|contact modulus|1e8 Pa|$(sizes 1) -var contact_modulus 1e8"
  "sleep_off|shortcut off|sleep 0|$(sizes 1) -var sleep 0"
  "gas_every_1|shortcut off|gas_every 1|$(sizes 1) -var gas_every 1"
  "push_off|shortcut off|push_softening 1|$(sizes 1) -var push_softening 1"
  "quiet_off|shortcut off|quiet 0|$(sizes 1) -var quiet 0"
  "gas_wait|shortcut off|gas_rest 1e-9|$(sizes 1) -var gas_rest 1e-9"
  "accuracy_quick|accuracy|quick|-var accuracy quick -var fragment_x50 0.455 -var block_min 0.19"
  "accuracy_fine|accuracy|fine|-var accuracy fine -var fragment_x50 0.28"
)

one_run() {  # one_run NAME VARIABLES...: leaves NAME/summary.json and NAME/seconds
  local folder=$out/runs/$1 TIMEFORMAT='%U %S'
  shift
  rm -rf "$folder"
  mkdir -p "$folder/dump"
  # shellcheck disable=SC2086 # $bench is many words
  { time "$program" -in inputs/bench/in.bench -log none -var out "$folder" $bench "$@" \
    >"$folder/screen" 2>&1 </dev/null; } 2>"$folder/seconds" || {
    tail -n 15 "$folder/screen"
    return 1
  }
  "$post" profile "$folder" >"$folder/post" 2>&1 || { tail -n 5 "$folder/post"; return 1; }
  rm -rf "$folder"/dump/blocks_*.{csv,bin} "$folder"/*.png
}

# On as many cores as there are, two at least: a run is on one core.
all_runs() {
  local rung name knob setting vars running=0 most failed=0
  most=$(nproc)
  for rung in "${ladder[@]}"; do
    IFS='|' read -r name knob setting vars <<<"$rung"
    if ((running >= most)); then
      wait -n || failed=1
      running=$((running - 1))
    fi
    echo "ladder: $name ($knob: $setting)"
    # shellcheck disable=SC2086
    one_run "$name" $vars &
    running=$((running + 1))
  done
  for ((; running > 0; running--)); do wait -n || failed=1; done
  return "$failed"
}

cd "$root"
all_runs || { echo "ladder: error: a run failed; see above and $out/runs" >&2; exit 1; }
printf '%s\n' "${ladder[@]}" | "$report" "$out" "$SECONDS"
cat "$out/ladder.md"
