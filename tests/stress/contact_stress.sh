#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# contact_stress.sh LIGGGHTS_MUCKPILE [NP]: runs in.contacts. Up to twice the step that contacts with dashpots bear the heap must rest with
# its energy balanced to 0.1 %; far above, both must be lost (the drift is 1 to 3 % there, by chance of the rattling).
set -euo pipefail
program=$1 ranks=${2:-1}
here=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")")
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_mpi_yield_when_idle=1 \
  OMPI_MCA_btl_vader_single_copy_mechanism=none

cd "$here/../.."
mpirun -np "$ranks" --oversubscribe --bind-to none "$program" -in "$here/in.contacts" -log none -var out "$out" "${@:3}" \
  >"$out/screen" 2>&1 || { tail -n 5 "$out/screen"; exit 1; }
grep '^contact_stress:' "$out/screen"
awk '
  $2 != "share" { next }
  { shares++; drift = $8 - $10; if (drift < 0) drift = -drift }
  $3 <= 2 && !($5 < 0.2 && drift < 1e-3) { print "  WRONG: must rest with its energy balanced at share " $3; wrong = 1 }
  $3 > 2 && !($5 > 50 && drift > 5e-3) { print "  WRONG: must rattle at share " $3; wrong = 1 }
  END { exit wrong || shares != 3 }' <(grep '^contact_stress:' "$out/screen")
