#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# run_expect.sh passes a refusal and nothing else; fake programs play the faults.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/script.sh"
run_expect=$here/run_expect.sh
cd "$out"
printf '# expect: burden must be > 0 m, got\nunits si\n' >case.in

verdict() {  # verdict NAME BODY: result of run_expect on a program with this body
  printf '#!/bin/bash\n%s\n' "$2" >"$1"
  chmod +x "$1"
  "$run_expect" "$out/$1" "$out/case.in" "${limit:-40}" >"$1.out" 2>&1
}
must_pass() { verdict "$@" || { echo "$1 failed: $(<"$1.out")"; exit 1; }; }
must_fail() {  # must_fail NAME BODY REASON
  if verdict "$1" "$2"; then echo "$1 passed"; exit 1; fi
  grep -qF "$3" "$1.out" || { echo "$1 failed for another reason: $(<"$1.out")"; exit 1; }
}
readonly message="echo \"ERROR: burden must be > 0 m, got '-1' (rock.cpp:3)\""

must_pass refusal "$message; exit 1"
must_fail acceptance "$message; exit 0" 'accepted the input'
must_fail other_message 'echo "ERROR: no such file"; exit 1' 'does not have: burden'
must_fail echoed_only 'echo "burden must be > 0 m, got"; exit 1' 'does not have: burden'
must_fail crash "$message; kill -SEGV \$\$" 'crashed'
limit=3 must_fail hang "$message; sleep 100" 'no answer within 3 s'
must_fail late "echo 'Step Atoms KinEng'; $message; exit 1" 'started before'

printf '# expect: got\n# expect: burden\n# np: 2\n' >case.in
# Both ranks run the program; only the first must speak.
must_pass two_ranks "[[ \$OMPI_COMM_WORLD_SIZE -eq 2 ]] || exit 0; $message; exit 1"
printf 'units si\n' >case.in
must_fail no_expectation "$message; exit 1" 'has no line'
