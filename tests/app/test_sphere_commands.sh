#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# test_sphere_commands.sh PROGRAM: LIGGGHTS' commands for spheres say that they have no effect on blocks, once each, and nothing where no
# block is meant.
set -euo pipefail
program=$1
source "$(dirname "${BASH_SOURCE[0]}")/../support/script.sh"
cd "$out"

cat >scene.in <<'EOF'
units si
atom_style granular
atom_modify map array
newton off
boundary f f f
communicate single vel yes
region box block -2 2 -2 2 -2 2 units box
create_box 1 box
neighbor 0.01 bin
timestep 1e-5
pair_style muckpile/block
pair_coeff * *
fix bodies all multisphere/muckpile
region rock block -1 1 -1 1 -1 1 units box
create_blocks rock density 2700 size uniform 0.7 block_min 0.7 block_max 0.7 spheres_per_block 1 sweeps 2
region nowhere block 1.9 2 1.9 2 1.9 2 units box
group none region nowhere
EOF

count() {  # count WORDS: warnings of that command
  grep -cE "^WARNING: $1: has no effect on blocks, .*; use block_motion" <<<"$output" || true
}

output=$({ cat scene.in; echo "velocity none set 1 0 0"; echo "velocity all set 1 0 0 units box"
  echo "displace_atoms all move 0.1 0 0 units box"; echo "run 10"; } >in && "$program" -log none -in in 2>&1 </dev/null) ||
  fail "the run must end well"
[[ $(count velocity) -eq 1 ]] || fail "velocity must warn once"
[[ $(count displace_atoms) -eq 1 ]] || fail "displace_atoms must warn once"

try_set() {  # try_set WORDS; LIGGGHTS may refuse the command behind the warning
  output=$({ cat scene.in; echo "run 0"; echo "set $1"; } >in && "$program" -log none -in in 2>&1 </dev/null) || true
}
for words in "group all vx 1" "type 1 x 0" "region rock omegaz 1" "atom 1*3 z 0"; do
  try_set "$words"
  [[ $(count set) -eq 1 ]] || fail "set $words must warn once"
done
for words in "group none vx 1" "region nowhere vx 1" "atom 1000000 vx 1" "group all density 2000"; do
  try_set "$words"
  [[ $(count set) -eq 0 ]] || fail "set $words must not warn"
done
