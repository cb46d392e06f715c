#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# test_end_of_input.sh PROGRAM: the log says whether all of an input has run, or a signal has cut it short; inputs without Muckpile's commands
# among them.
set -euo pipefail
program=$1
source "$(dirname "${BASH_SOURCE[0]}")/../support/script.sh"
cd "$out"

scene='units si
atom_style granular
atom_modify map array sort 0 0
boundary f f f
newton off
communicate single vel yes
region box block -2 2 -2 2 -2 2 units box
create_box 1 box
neighbor 0.1 bin
fix integrate all nve/sphere
timestep 1e-6'
stop='shell "kill -USR2 $PPID"'  # the engine runs the shell

ends() {  # ends LINE TEXT_OF_INPUT [ON SCREEN]
  rm -f log.liggghts
  printf '%s\n' "$scene" "$2" >in.plain
  output=$("$program" -in in.plain </dev/null 2>&1) || fail "exit status $?"
  [[ $(grep -E '^(whole|interrupted): ' log.liggghts) == "$1" ]] || fail "the log must say '$1' of: $2"$'\n'"$(tail -n 3 log.liggghts)"
  [[ $(grep -c "^${1%%:*}: " <<<"$output") -eq $([[ $1 == whole* ]] && echo 0 || echo 1) ]] || fail "the screen must tell of a cut only"
}
whole='whole: the input has run to its end'
ends "$whole" 'run 10'
ends "$whole" "run 10
$stop
# nothing

"
ends 'interrupted: before the end of the input' "run 10
$stop
run 5"
printf '%s\nrun 5\n' "$stop" >in.part
ends 'interrupted: before the end of the input' 'run 10
include in.part'
printf 'run 5\n%s' "$stop" >in.part
ends 'interrupted: before the end of the input' 'include in.part
print more'

ends 'interrupted: before the end of the input' "if '1 == 1' then \"shell 'kill -USR2 \$PPID'\" 'run 10'"
ends 'interrupted: before the end of the input' "run 20 every 10 &
  \"shell 'kill -USR2 \$PPID'\""
ends 'interrupted: before the end of the input' "write_restart_on_signal no
run 10
$stop"

# A last run_blocks that is left before its first step, as a signal has come to the second rank alone.
cat >signal_others.sh <<'END'
# signal_others.sh RANK: to the other children of its parent.
parent=$(awk '/^PPid:/ {print $2}' "/proc/$1/status")
for process in /proc/[0-9]*; do
  [ "${process#/proc/}" = "$1" ] || ! grep -qs "^PPid:[[:space:]]*$parent\$" "$process/status" || kill -USR2 "${process#/proc/}"
done
END
cat >in.blocks <<END
units si
atom_style granular
atom_modify map array sort 0 0
boundary m m m
newton off
communicate single vel yes
region box block -2 4 -2 4 -2 4 units box
create_box 1 box
neighbor 0.2 bin
neigh_modify delay 0 every 1 check yes binsize 1.5
variable contact_modulus index 2.5e7
variable restitution index 0.3
variable friction index 0.7
variable rolling_friction index 1.0
include $root/inputs/common/contact.in
fix blocks all multisphere/muckpile
region rock block 0 1 0 1 0 1 units box
create_blocks rock density 2700 size uniform 0.5 block_min 0.5 block_max 0.5 cut joint_sets joint_set 90 0 joint_set 90 90 spheres_per_block 1 &
  sphere_growth 1 file blocks.vtk
shell "sh signal_others.sh \$PPID"
run_blocks phase rest until still directory . time_end 1 still_share 0.002 solid rock density 2700 block_min 0.5 spheres_per_block 1 steps_per_contact 10
END
rm -f log.liggghts
unset output
on_ranks 2 -in in.blocks </dev/null >screen 2>&1 || fail "exit status $?"
[[ $(grep -E '^(whole|interrupted): ' log.liggghts) == 'interrupted: before the first step of phase rest
interrupted: before the end of the input' ]] || fail "an input whose last phase was left out must not be whole: $(grep -E '^(whole|interrupted): ' log.liggghts)"

# A pipe that stays open is not waited for.
mkfifo pipe
(printf '%s\nrun 10\n%s\n' "$scene" "$stop"; exec sleep 60) >pipe &
writer=$!
timeout 30 "$program" <pipe >screen 2>&1 || fail "the engine waits for more of its input"
kill "$writer"

# A signal in the middle of a plain run, which looks for signals where it writes.
printf '%s\nthermo 1000\nrun 2000000000\n' "$scene" >in.plain
rm -f log.liggghts screen  # the one before has the line that is waited for
"$program" -in in.plain >screen 2>&1 </dev/null &
engine=$!
for ((k = 0; k < 300; ++k)); do
  if grep -qs '^ *Step' screen; then break; fi
  sleep 0.1
done
kill -USR2 "$engine"
wait "$engine" || fail "exit status $?"
[[ $(grep -E '^(whole|interrupted): ' log.liggghts) == 'interrupted: before the last step of a run' ]] || fail "a run cut short is not told: $(tail -n 3 log.liggghts)"

# An error leaves no line.
printf '%s\nno_such_command\n' "$scene" >in.plain
! "$program" -in in.plain >screen 2>&1 </dev/null || fail "an error ends well"
! grep -qE '^(whole|interrupted): ' log.liggghts || fail "an input with an error is called whole"
