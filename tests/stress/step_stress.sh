#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# step_stress.sh LIGGGHTS_MUCKPILE [NP]: runs in.step at 0.1 to 1.5 of the longest stable step. Up to 1 it must end well
# with its energy balanced; above, it must stop with the message of fix muckpile/progress and leave a restart file,
# which the next run must refuse by that message.
set -euo pipefail
program=$1 ranks=${2:-1}
source "$(dirname "${BASH_SOURCE[0]}")/../support/script.sh"
source "$root/tests/support/check_figures.sh"

wrong=0
is_wrong() { echo "  WRONG: $1"; tail -n 5 "$out/screen"; wrong=1; }

try() {  # try SHARE ends|stops [variables]
  local share=$1 expected=$2 status=0
  shift 2
  rm -rf "$out/dump" "$out/screen" "$out/figures.json"
  on_ranks "$ranks" -in "$here/in.step" -log none -var out "$out" \
    -var share "$share" "$@" >"$out/screen" 2>&1 || status=$?
  local said
  said=$(grep -E "^step_stress:|fix muckpile/progress 'progress':" "$out/screen" | tail -n 1 || true)
  echo "share $share $*: status $status, ${said:-nothing said}"
  if [[ $expected == ends ]]; then
    [[ $status -eq 0 ]] || is_wrong "must end well"
    check_figures near "energy balance" "$out/figures.json:energy_balance" 0 0.01 || is_wrong "energy is not balanced"
  else
    [[ $status -ne 0 ]] || is_wrong "must stop"
    [[ $said == *"the time step"* ]] || is_wrong "must say that the time step is too long"
    [[ -s $out/dump/stopped.restart ]] || is_wrong "must leave stopped.restart"
    status=0
    on_ranks "$ranks" -in "$here/in.step" -log none -var out "$out" \
      -var go_on 1 -var share 0.1 "$@" >"$out/screen" 2>&1 || status=$?
    [[ $status -ne 0 ]] && grep -qE "^ERROR: .*(It is so in the restart file that was read|not a number; go on from)" "$out/screen" ||
      is_wrong "stopped.restart must be refused"
  fi
}

for share in 0.1 0.5 0.8 1.0; do try $share ends; done
for share in 1.05 1.2 1.5; do try $share stops; done
# Rock that breaks: the bound covers whatever breaks.
for share in 0.5 1.0; do try $share ends -var strength 4e6 -var breaking possible; done
try 1.5 stops -var strength 4e6 -var breaking possible
exit $wrong
