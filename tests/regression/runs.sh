# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck shell=bash disable=SC2154
# What the scripts beside it share: runs of an input in folders of $out, and their figures. What a failed script has written stays,
# and its place is printed.
# Scope: to be sourced, once $program is set. It goes to the root of the project.
source "$(dirname "${BASH_SOURCE[0]}")/../support/script.sh"
source "$root/tests/support/check_figures.sh"
cd "$root" || exit
trap 'status=$?; rm -rf "$sessions"; if [[ $status -eq 0 ]]; then rm -rf "$out"; else echo "kept: $out"; fi' EXIT

run_input() {  # run_input FOLDER RANKS INPUT [-var NAME VALUE]...: to $out/FOLDER
  local to=$out/$1 ranks=$2 input=$3
  shift 3
  mkdir -p "$to/dump"
  on_ranks "$ranks" -in "$input" -log none -var out "$to" "$@" >"$to/screen" 2>&1 ||
    { tail -n 30 "$to/screen"; exit 1; }
}

of_run() { check_figures print "$out/$1/dump/run.json:$2"; }  # of_run FOLDER QUANTITY

compare() { check_figures near "$@" --share; }  # compare QUANTITY VALUE REFERENCE BOUND: BOUND is a share of REFERENCE
