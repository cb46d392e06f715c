# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck shell=bash disable=SC2034
# What tests by script share: an empty folder $out, which goes at the end, the folder $here of the script, the $root of the project, and an
# end that says why.
# Scope: to be sourced behind `set -euo pipefail`, from the folder where the script was called; it changes to no other.
here=$(dirname "$(readlink -f "$0")")
root=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../..")
out=$(mktemp -d)
sessions=$(mktemp -d)
trap 'rm -rf "$out" "$sessions"' EXIT
# As MUCKPILE_MPI_ENVIRONMENT of cmake/AddTests.cmake.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_mpi_yield_when_idle=1 \
  OMPI_MCA_btl_vader_single_copy_mechanism=none
# A job of Open MPI that ends removes the folder that all share, in which another may be about to begin.
export OMPI_MCA_orte_tmpdir_base=$sessions

fail() {  # fail TEXT...: with what the program has printed last, which is in $output or $out/screen
  printf '%s\n' "$(basename "$0" .sh): $*" "--- output:" "${output-$(cat "$out/screen" 2>/dev/null || true)}"
  exit 1
}

on_ranks() { mpirun -np "$1" --oversubscribe --bind-to none "$program" "${@:2}"; }  # on_ranks RANKS OPTION...: $program
