#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# decoupled_zone.sh LIGGGHTS_MUCKPILE: a bench is cut and blasted with a charge that fills its hole, one in air whose zone is narrower, and one whose zone
# is no wider than the hole. The wave begins with one pressure on the first two and with less on the third, and the blocks at the wall stay as large.
# Scope: radii and peaks by hand are in the unit tests; here they go through the inputs, to create_blocks and to fix muckpile/blast.
set -euo pipefail
program=$1
source "$(dirname "${BASH_SOURCE[0]}")/runs.sh"

# loads NAME TEXT [-var NAME VALUE]...: the blast prints TEXT, and runs to its end.
loads() {
  local name=$1 text=$2
  shift 2
  run_input "$name" 1 inputs/bench/in.bench -var accuracy quick -var bench_height 3 -var burden 1.5 -var hole_diameter 0.06 -var time_end 0.02 "$@"
  grep -qF -- "$text" "$out/$name/screen" || fail "$name has not '$text': $(grep 'wave peak' "$out/$name/screen")"
  grep -q 'block_min 0.235 m is wider than .* 0\.1799[0-9]* m is taken' "$out/$name/screen" || fail "$name: other blocks at the wall"
}

loads full 'wave peak P1 = 535.5 MPa on r1 = 0.09004 m' &
loads air 'wave peak P1 = 535.5 MPa on r1 = 0.05345 m' -var charge_diameter 0.048
wait $!
loads thin 'wave peak P1 = 230.6 MPa on r1 = 0.03 m (1 hole radii' -var charge_diameter 0.024 &
loads as_full 'wave peak P1 = 244.9 MPa on r1 = 0.09004 m' -var charge_diameter 0.048 -var decoupled_zone full
wait $!
