#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# buffer.sh LIGGGHTS_MUCKPILE MUCKPILE_POST: a small bench behind no muck, behind a buffer, and behind the pile that the first one has left: the
# buffer lies at rest with all of its mass and a slope as loose rock has, takes up momentum, and holds the burden back; the same on two ranks, and
# where the pour was interrupted.
# Scope: inputs/bench until the burden is in flight. What a buffer does at full size is in the bench's README.
set -euo pipefail
program=$1 post=$2
source "$(dirname "${BASH_SOURCE[0]}")/runs.sh"
readonly bench=inputs/bench/in.bench
readonly small=(-var accuracy quick -var bench_height 4 -var burden 1.6 -var hole_diameter 0.05 -var time_end 0.25)
readonly buffer=(-var buffer 2 -var buffer_height 3 -var buffer_size 0.5)
wrong=0
key() { check_figures print "$out/$1/summary.json:$2"; }

# 3 m of loose muck, 2 m wide, for a swell of 1.4 and over the spacing of 2 m, in granite: 2 x 2 x 3 / 1.4 m3 x 2650 kg/m3.
run_input buffered 1 "$bench" "${small[@]}" "${buffer[@]}" &
run_input free 1 "$bench" "${small[@]}"
wait $!
"$post" heap "$out/buffered/muck" >/dev/null
# At rest: 0.05 m/s in the mean, where 0.03 were measured; the speed that a fall of 0.1 mm gives.
check_figures bounds "kinetic energy of the muck [J]" "$out/buffered/muck/dump/history.csv:kinetic_J" --at-most 28 || wrong=1
check_figures bounds "swell of the muck" "$out/buffered/muck/summary.json:swell_factor" --at-least 1.25 --at-most 1.6 || wrong=1
check_figures bounds "front slope of the muck [degrees]" "$out/buffered/muck/summary.json:repose_angle_deg" --at-least 28 --at-most 50 || wrong=1
check_figures near "energy balance of the pour" "$out/buffered/muck/dump/run.json:energy_balance_error" 0 0.02 || wrong=1

for run in free buffered; do "$post" profile "$out/$run" >/dev/null; done
compare "mass of the muck [kg]" "$(key buffered muck_mass_kg)" 22714.29 1e-6 || wrong=1
check_figures bounds "throw behind the buffer [m]" "$(key buffered throw_cg_m)" --at-most "$(key free throw_cg_m)" || wrong=1
check_figures bounds "the muck was pushed [m]" "$(key buffered muck_moved_m)" --at-least 0.02 || wrong=1
check_figures near "energy balance" "$out/buffered/dump/run.json:energy_balance_error" 0 0.02 || wrong=1

# The second row behind the first one's pile, which is in flight still.
run_input second 1 "$bench" "${small[@]}" -var muck "$out/free" &
second=$!

# A pour that is told to stop leaves its state, goes on from there, and comes to rest with all of its mass.
mkdir -p "$out/part"
part=(-in "$bench" -log none "${small[@]}" "${buffer[@]}" -var out "$out/part")
state=
for _ in 1 2 3; do  # on a busy machine the pour may be over before it is told
  "$program" "${part[@]}" >"$out/part/screen" 2>&1 &
  engine=$!
  while ! grep -qs ',poured,' "$out/part/muck/dump/history.csv" && kill -0 "$engine" 2>/dev/null; do sleep 0.05; done
  kill -TERM "$engine"
  wait "$engine" || wrong=1
  state=$(sed -nE "s/^interrupted: the state is in '(.*)'$/\1/p" "$out/part/screen")
  [[ -z $state ]] || break
  rm -f -- "$out/part/muck/dump/history.csv"
done
mv -- "$state" "$out/part/state.restart"
"$program" "${part[@]}" -var pour_from "$out/part/state.restart" >"$out/part/screen_on" 2>&1 || wrong=1
poured_kg() { sed -nE 's/^  muck: .* mean, ([0-9.e+]+) kg.*/\1/p' "$out/$1"; }
compare "mass of the muck of a pour that goes on [kg]" "$(poured_kg part/screen_on)" "$(poured_kg buffered/screen)" 1e-6 || wrong=1
check_figures bounds "energy balance of a pour that goes on" "$out/part/muck/dump/run.json:energy_balance_error" --at-most 0.02 || wrong=1

wait "$second"
grep '^  muck: ' "$out/second/screen"
"$post" profile "$out/second" >/dev/null
check_figures bounds "muck of the first row [kg]" "$(key second muck_mass_kg)" --at-least 5000 || wrong=1

run_input two 2 "$bench" "${small[@]}" "${buffer[@]}"
"$post" profile "$out/two" >/dev/null
compare "work of the gas [J], on 2 ranks" "$(of_run two gas_work_J)" "$(of_run buffered gas_work_J)" 0.02 || wrong=1
compare "throw [m], on 2 ranks" "$(key two throw_cg_m)" "$(key buffered throw_cg_m)" 0.1 || wrong=1
exit $wrong
