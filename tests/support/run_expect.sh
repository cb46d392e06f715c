#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# run_expect.sh PROGRAM INPUT [SECONDS]: passes if PROGRAM refuses the input script INPUT as it says itself.
# INPUT states in comment lines what must happen:
#   # expect: TEXT   part of the error message (one or more such lines)
#   # np: 2          number of ranks (default 1)
#   # runs before    the fault is in a later run; steps before it are no fault of the test
# Refusing means: an exit status of its own (no signal, no time-out), every TEXT on one line that
# starts with ERROR, and not one time step. The run happens in the present folder; the script finds
# its own as ${dir}.
set -euo pipefail
program=$1
input=$2
seconds=${3:-60}

fail() {
  printf '%s\n' "run_expect: $*" "--- output:" "${output-}"
  exit 1
}

mapfile -t expected < <(sed -nE 's/^# expect: (.*)$/\1/p' "$input")
[[ ${#expected[@]} -gt 0 ]] || fail "$input has no line '# expect: TEXT'"
np=$(sed -nE 's/^# np: ([0-9]+)$/\1/p' "$input")

# mpirun waits a second for the ranks that a refusal leaves, which have nothing more to say.
export OMPI_MCA_odls_base_sigkill_timeout=0
# A job of Open MPI that ends removes the folder that all share, in which another may be about to begin.
OMPI_MCA_orte_tmpdir_base=$(mktemp -d)
export OMPI_MCA_orte_tmpdir_base
trap 'rm -rf "$OMPI_MCA_orte_tmpdir_base"' EXIT
status=0
output=$(OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 \
  OMPI_MCA_btl_vader_single_copy_mechanism=none \
  timeout -k 5 "$seconds" mpirun -np "${np:-1}" --oversubscribe --bind-to none \
  "$program" -in "$input" -log none -var dir "$(dirname "$input")" 2>&1 </dev/null) || status=$?

[[ $status -ne 0 ]] || fail "the program accepted the input"
[[ $status -ne 124 && $status -ne 137 ]] || fail "no answer within $seconds s"
[[ $status -lt 126 ]] || fail "the program crashed (exit status $status)"
for text in "${expected[@]}"; do
  grep '^ERROR' <<<"$output" | grep -qF -- "$text" || fail "the message does not have: $text"
done
! grep -qE '^ *Step |^Loop time' <<<"$output" || grep -qx '# runs before' "$input" || fail "the run started before the error was found"
